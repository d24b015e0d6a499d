package tellosimulator.replay;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import tellosimulator.goal.GoalEvent;
import tellosimulator.goal.GoalWatch;
import tellosimulator.network.OfflineNetwork;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.InitialConditions;
import tellosimulator.recording.RecordedInput;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Simulation;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/** A simulation that is handed the inputs of an earlier one, and recorded. For one thread. */
final class RepeatedFlight {

  /** Steps from writing to writing. Decided: some thousand lines. */
  private static final long WRITING_STEPS = 2000;

  private final RecordingFolder into;
  private final int earlier;
  private final List<Phrase> failures = new ArrayList<>();
  private final FlightRecorder recorder;
  private final Simulation simulation;
  private long steps;

  /**
   * Begins it.
   *
   * @param start what it begins from
   * @param title of the scenario
   * @param scenario what is kept of it
   * @param into where it is recorded
   */
  RepeatedFlight(InitialConditions start, String title, Scenario scenario, RecordingFolder into) {
    this.into = into;
    this.earlier = into.made().size();
    GoalWatch goals = new GoalWatch(start.challenge(), this::tell);
    Scenario flown =
        new Scenario(
            scenario.description(), start.config(), scenario.stations(), start.challenge());
    recorder =
        FlightRecorder.stepped(
            into, new FlightRecorder.Subject(title, flown, List.of(), goals), failures::add);
    OfflineNetwork network = new OfflineNetwork(recorder);
    simulation =
        new Simulation(
            start.config(), network.replies(start.replyPort()), network.states(), List.of(goals));
    network.listen(simulation);
    recorder.attach(simulation, start.replyPort());
  }

  private void tell(GoalEvent news) {
    recorder.event(news);
  }

  /** Gives inputs one after another. */
  @FunctionalInterface
  interface Inputs {

    /** The next one; empty after the last. */
    Optional<RecordedInput> next() throws IOException;
  }

  /**
   * Flies until a moment.
   *
   * @return the folder of the last flight until then; those before it are deleted
   * @throws IOException with a sentence, if inputs cannot be read, or nothing be written, or no
   *     drone took off
   */
  Path fly(Inputs inputs, SimTime end) throws IOException {
    try (recorder) {
      for (Optional<RecordedInput> next = inputs.next();
          next.isPresent() && !end.isBefore(next.get().time());
          next = inputs.next()) {
        advance(next.get().time());
        repeat(next.get());
      }
      advance(end);
    }
    check();
    List<Path> made = into.made();
    if (made.size() == earlier) {
      throw new IOException("no drone took off");
    }
    for (Path before : made.subList(earlier, made.size() - 1)) {
      delete(before);
    }
    return made.get(made.size() - 1);
  }

  private void repeat(RecordedInput input) throws IOException {
    try {
      simulation.repeat(input.input());
    } catch (IllegalArgumentException e) {
      String where = String.format(Locale.ROOT, "at %.3f s", input.time().seconds());
      throw new IOException("its inputs are damaged " + where + ": " + e.getMessage(), e);
    }
  }

  private void advance(SimTime until) throws IOException {
    while (simulation.time().isBefore(until)) {
      simulation.step();
      steps++;
      if (steps % WRITING_STEPS == 0) {
        recorder.writeWaiting();
        check();
      }
    }
  }

  private void check() throws IOException {
    if (!failures.isEmpty()) {
      throw new IOException(failures.get(0).english());
    }
  }

  private static void delete(Path recording) throws IOException {
    try (DirectoryStream<Path> files = Files.newDirectoryStream(recording)) {
      for (Path file : files) {
        Files.delete(file);
      }
    }
    Files.delete(recording);
  }
}
