package tellosimulator.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Stream;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.InitialConditions;
import tellosimulator.recording.RecordedCommand;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedInputs;
import tellosimulator.recording.RecordedRun;
import tellosimulator.recording.RecordingFile;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * A recorded flight that can be replayed: from the beginning of the simulation, the same inputs are
 * applied after the same steps. Immutable; {@link #fly} runs on the calling thread.
 */
public final class Replay {

  /**
   * Maximum time for which a recording may continue after its last line [s]. Decided: twice the
   * silence after which the recording of a real drone ends.
   */
  private static final double LONGEST_REST = 120;

  /** The files whose last lines show how long a recording lasts. */
  private static final List<RecordingFile> LAST_LINES =
      List.of(RecordingFile.WIRE, RecordingFile.EVENTS, RecordingFile.FLIGHT);

  private final Path folder;
  private final RecordedRun run;
  private final List<Phrase> outlineRemarks;
  private final InitialConditions start;
  private final Scenario scenario;

  /** The time of the last line [s]. */
  private final double lastLine;

  /**
   * The commands that were sent; empty if all inputs were recorded, because the inputs are used
   * instead.
   */
  private final Optional<List<RecordedCommand>> commands;

  private Replay(
      Path folder,
      RecordedFlight outline,
      InitialConditions start,
      Optional<List<RecordedCommand>> commands)
      throws IOException {
    this.folder = folder;
    this.run = outline.run();
    this.outlineRemarks = outline.remarks();
    this.start = start;
    this.scenario =
        outline
            .scenario()
            .filter(kept -> kept.stations().size() == start.config().drones().size())
            .orElseGet(() -> Scenario.of(start.config()));
    this.commands = commands;
    this.lastLine = lastLine(folder);
  }

  /**
   * Reads the initial conditions of a recording. A recording that lacks some inputs, such as a
   * recording of a real drone, is replayed in its recorded room with its recorded commands.
   *
   * @param folder the recording's folder
   * @throws UnreadableRecordingException if the folder contains no readable recording; the message
   *     is one sentence
   * @throws IOException if the recording cannot be read
   */
  public static Replay of(Path folder) throws UnreadableRecordingException, IOException {
    RecordedFlight outline = RecordedFlight.readOutline(folder);
    Optional<RecordedInputs> inputs = RecordedInputs.open(folder);
    if (inputs.isPresent()) {
      try (RecordedInputs opened = inputs.get()) {
        return new Replay(folder, outline, opened.start(), Optional.empty());
      }
    }
    RecordedFlight flight = RecordedFlight.read(folder);
    Scenario known = flight.scenario().orElseGet(() -> Scenario.of(config(flight.run())));
    return new Replay(
        folder,
        flight,
        new InitialConditions(known.config(), known.challenge(), OptionalInt.empty()),
        Optional.of(flight.commands()));
  }

  /**
   * Whether all inputs are known, so that the same program version reproduces the recording byte
   * for byte.
   */
  boolean exact() {
    return commands.isEmpty();
  }

  /**
   * Replays the flight and records it.
   *
   * @param into the folder that will contain the folder of the new recording
   * @return the folder of the new recording
   * @throws IOException if the inputs cannot be read, the recording cannot be written, or no drone
   *     took off; the message is a clause, without a capital or a full stop
   */
  public Path fly(RecordingFolder into) throws IOException {
    return flown(into).folder;
  }

  /**
   * Replays the flight and judges it again, until the end of the recording.
   *
   * @param into the folder that will contain the folder of the new recording
   * @throws IOException as for {@link #fly}
   */
  public FlightResult judge(RecordingFolder into) throws IOException {
    return flown(into).result;
  }

  /**
   * The result of a replay.
   *
   * @param damaged the number of inputs that could not be read
   * @param result the outcome of the attempt
   */
  private record Flown(Path folder, int damaged, FlightResult result) {}

  private Flown flown(RecordingFolder into) throws IOException {
    if (commands.isPresent()) {
      return fly(new PacedCommands(commands.get(), start.config().drones().size()), into);
    }
    try (RecordedInputs inputs = RecordedInputs.open(folder).orElseThrow()) {
      Flown flown = fly(new Inputs.Exact(inputs, end()), into);
      return new Flown(flown.folder, inputs.damaged(), flown.result);
    }
  }

  private Flown fly(Inputs inputs, RecordingFolder into) throws IOException {
    RepeatedFlight flight =
        new RepeatedFlight(start, run.setting().scenario(), scenario, inputs, into);
    return new Flown(flight.fly(), 0, flight.result());
  }

  /** The end of the last recorded step. */
  private SimTime end() {
    double end = ended().orElse(lastLine);
    return new SimTime(Math.round(end / SimTime.STEP) * SimTime.STEP_NANOS);
  }

  /** The recorded end of the flight [s]; empty if it is missing or implausible. */
  private OptionalDouble ended() {
    return run.ended().stream()
        .filter(ended -> ended >= 0 && ended <= lastLine + LONGEST_REST)
        .findFirst();
  }

  private static double lastLine(Path folder) throws IOException {
    double last = 0;
    for (RecordingFile file : LAST_LINES) {
      last = Math.max(last, LineFile.lastTime(file.in(folder)));
    }
    return last;
  }

  /**
   * Replays the flight and compares both recordings.
   *
   * @param into the folder that will contain the folder of the new recording
   * @throws IOException as for {@link #fly}
   */
  public Repetition repeat(RecordingFolder into) throws IOException {
    Flown again = flown(into);
    return new Repetition(
        again.folder,
        exact(),
        exact() ? Difference.between(folder, again.folder, ended().isEmpty()) : List.of(),
        remarks(again.damaged));
  }

  private List<Phrase> remarks(int damaged) {
    List<Phrase> remarks = new ArrayList<>(outlineRemarks);
    if (!RecordedRun.version().equals(run.program())) {
      remarks.add(
          Phrase.of(
              "it was recorded by version %s, and flown again by version %s",
              run.program(), RecordedRun.version()));
    }
    if (run.ended().isPresent() && ended().isEmpty()) {
      remarks.add(Phrase.of("its end is damaged, so that it was flown as far as its lines go"));
    }
    if (damaged > 0) {
      remarks.add(
          Phrase.of(
              "%d lines of %s are damaged and left out", damaged, RecordingFile.INPUTS.fileName()));
    }
    if (!exact()) {
      remarks.add(
          Phrase.of(
              "%s, so that only its commands were flown again, each after the reply that its program"
                  + " waited for; replies, durations and motion are compared, single bytes are not",
              whyNotExact()));
    }
    return remarks;
  }

  private Phrase whyNotExact() {
    if (run.realDrone().isPresent()) {
      return Phrase.of("a real drone flew");
    }
    return RecordedInputs.areKept(folder)
        ? Phrase.of("this version cannot read what it begins from")
        : Phrase.of("it does not tell all that happened since the simulation began");
  }

  /**
   * Returns a configuration for a recording without a scenario. It is derived from the general data
   * of the flight.
   */
  private static SimConfig config(RecordedRun run) {
    Product usual = usual(run);
    List<DroneSetup> setups = new ArrayList<>();
    for (RecordedRun.DroneEntry drone : run.setting().drones()) {
      Product product =
          new Product(
              option(Profile.values(), drone.profile(), usual.profile()),
              option(Behavior.values(), drone.behavior(), usual.behavior()));
      setups.add(DroneSetup.at(drone.start(), product, StreamPorts.DEFAULT));
    }
    SimConfig config =
        SimConfig.DEFAULT
            .withArena(SimConfig.DEFAULT.arena().withRoom(run.setting().room()))
            .withProduct(usual.profile(), usual.behavior())
            .withSeed(run.seed().orElse(SimConfig.DEFAULT.seed()));
    return setups.isEmpty() ? config : config.withDrones(setups);
  }

  /**
   * Returns the default product of the drones; for a real drone, the product whose model is based
   * on measurements.
   */
  private static Product usual(RecordedRun run) {
    return run.realDrone().isPresent()
        ? new Product(Product.DEFAULT.profile(), Behavior.MEASURED)
        : Product.DEFAULT;
  }

  private static <T extends Enum<T>> T option(T[] known, String word, T other) {
    return Stream.of(known)
        .filter(each -> each.name().equalsIgnoreCase(word))
        .findFirst()
        .orElse(other);
  }
}
