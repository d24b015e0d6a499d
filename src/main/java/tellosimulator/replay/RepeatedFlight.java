package tellosimulator.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import tellosimulator.goal.GoalEvent;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.network.OfflineNetwork;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.InitialConditions;
import tellosimulator.recording.RecordedInputs.RecordedInput;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Simulation;
import tellosimulator.words.Phrase;

/**
 * A simulation that receives the inputs of a recorded simulation, and is itself recorded. Not
 * thread-safe.
 */
final class RepeatedFlight {

  /** Number of steps between writes. Decided: these produce a few thousand lines. */
  private static final long WRITING_STEPS = 2000;

  private final RecordingFolder into;
  private final int earlier;
  private final List<Phrase> failures = new ArrayList<>();
  private final Inputs inputs;
  private final FlightRecorder recorder;
  private final GoalWatch goals;
  private final Simulation simulation;
  private long steps;

  /**
   * Creates the simulation.
   *
   * @param start the initial conditions of the simulation
   * @param title title of the scenario
   * @param scenario the scenario as far as it was recorded
   * @param inputs the inputs of the simulation
   * @param into the folder that will contain the new recording
   */
  RepeatedFlight(
      InitialConditions start,
      String title,
      Scenario scenario,
      Inputs inputs,
      RecordingFolder into) {
    this.inputs = inputs;
    this.into = into;
    this.earlier = into.made().size();
    goals = new GoalWatch(start.challenge(), this::tell);
    Scenario flown =
        new Scenario(
            scenario.description(), start.config(), scenario.stations(), start.challenge());
    recorder =
        FlightRecorder.stepped(
            into, new FlightRecorder.Subject(title, flown, List.of(), goals), failures::add);
    OfflineNetwork network = new OfflineNetwork(recorder);
    simulation =
        new Simulation(start.config(), network.senders(start.replyPort()), List.of(goals, inputs));
    recorder.attach(simulation, start.replyPort());
  }

  private void tell(GoalEvent news) {
    recorder.event(news);
  }

  /**
   * Runs the simulation until the inputs end.
   *
   * @return the folder of the last flight; the recordings of earlier flights are deleted
   * @throws IOException if the inputs cannot be read, the recording cannot be written, or no drone
   *     took off; the message is a clause, without a capital or a full stop
   */
  Path fly() throws IOException {
    try (recorder) {
      repeatDue();
      while (inputs.goesOn(simulation.time())) {
        step();
        repeatDue();
      }
      goals.close(); // as at the end of the run
    }
    check();
    List<Path> made = into.made();
    if (made.size() == earlier) {
      throw new IOException("no drone took off");
    }
    for (Path before : made.subList(earlier, made.size() - 1)) {
      RecordingFolder.delete(before);
    }
    return made.get(made.size() - 1);
  }

  /** Returns the outcome. Must be called after {@link #fly}. */
  FlightResult result() {
    Progress last = goals.progress();
    return FlightResult.of(last, false, last.score(), goals.tally());
  }

  private void repeat(RecordedInput input) throws IOException {
    try {
      simulation.repeat(input.input());
    } catch (IllegalArgumentException e) {
      String where = String.format(Locale.ROOT, "at %.3f s", input.time().seconds());
      throw new IOException("its inputs are damaged " + where + ": " + e.getMessage(), e);
    }
  }

  private void repeatDue() throws IOException {
    for (Optional<RecordedInput> due = inputs.due(simulation.time());
        due.isPresent();
        due = inputs.due(simulation.time())) {
      repeat(due.get());
    }
  }

  private void step() throws IOException {
    simulation.step();
    steps++;
    if (steps % WRITING_STEPS == 0) {
      recorder.writeWaiting();
      check();
    }
  }

  private void check() throws IOException {
    if (!failures.isEmpty()) {
      throw new IOException(failures.get(0).english());
    }
  }
}
