package tellosimulator.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedInput;
import tellosimulator.recording.RecordedInputs;
import tellosimulator.recording.RecordedRun;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.Start;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.scenario.Scenario;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * A recorded flight that can be flown again: the same inputs after the same steps, from the moment
 * at which the simulation began. Immutable; for any thread, and {@link #fly} works on the calling
 * one.
 */
public final class Replay {

  /** Files that tell how far a recording goes that was cut off. */
  private static final List<String> LAST_LINES =
      List.of("wire.jsonl", "events.jsonl", "flight.csv");

  private final Path folder;
  private final RecordedRun run;
  private final Start start;
  private final Scenario scenario;

  /** Commands that were sent; empty if all inputs are kept. */
  private final Optional<List<RecordedInput>> commands;

  private Replay(
      Path folder, RecordedFlight outline, Start start, Optional<List<RecordedInput>> commands) {
    this.folder = folder;
    this.run = outline.run();
    this.start = start;
    this.scenario =
        outline
            .scenario()
            .filter(kept -> kept.stations().size() == start.config().drones().size())
            .orElseGet(() -> Scenario.of(start.config()));
    this.commands = commands;
  }

  /**
   * Reads what a recording began from. One that does not tell all inputs, as of a real drone, is
   * flown in the room that it names with the commands that it tells.
   *
   * @param folder in which it is
   * @throws UnreadableRecordingException with a sentence, if there is none
   * @throws IOException if it cannot be read
   */
  public static Replay of(Path folder) throws UnreadableRecordingException, IOException {
    RecordedFlight outline = RecordedFlight.readOutline(folder);
    Optional<RecordedInputs> inputs = RecordedInputs.open(folder);
    if (inputs.isPresent()) {
      try (RecordedInputs opened = inputs.get()) {
        return new Replay(folder, outline, opened.start(), Optional.empty());
      }
    }
    WireInputs wire = WireInputs.read(folder, outline);
    return new Replay(folder, outline, wire.start(), Optional.of(wire.commands()));
  }

  /** Whether all inputs are known, so that the same version does the same to the byte. */
  public boolean exact() {
    return commands.isEmpty();
  }

  /**
   * Flies it again, and records that.
   *
   * @param into where there will be a folder for it
   * @return that folder
   * @throws IOException with a clause, if inputs cannot be read, or nothing be written, or no drone
   *     took off
   */
  public Path fly(RecordingFolder into) throws IOException {
    RepeatedFlight flight = new RepeatedFlight(start, run.setting().scenario(), scenario, into);
    SimTime end = end();
    if (commands.isPresent()) {
      Iterator<RecordedInput> iterator = commands.get().iterator();
      return flight.fly(
          () -> iterator.hasNext() ? Optional.of(iterator.next()) : Optional.empty(), end);
    }
    try (RecordedInputs inputs = RecordedInputs.open(folder).orElseThrow()) {
      return flight.fly(inputs::next, end);
    }
  }

  /** The end of the step after which nothing was recorded any more. */
  private SimTime end() throws IOException {
    OptionalDouble ended = run.ended();
    double last = ended.orElse(0);
    for (String file : ended.isPresent() ? List.<String>of() : LAST_LINES) {
      last = Math.max(last, LineFile.lastTime(folder.resolve(file)));
    }
    return new SimTime(Math.round(last / SimTime.STEP) * SimTime.STEP_NANOS);
  }

  /**
   * Flies it again, and says where both recordings differ.
   *
   * @param into where there will be a folder for it
   * @throws IOException as {@link #fly}
   */
  public Repetition repeat(RecordingFolder into) throws IOException {
    Path again = fly(into);
    return new Repetition(
        again, Difference.between(folder, again, run.ended().isEmpty()), remarks());
  }

  private List<Phrase> remarks() {
    List<Phrase> remarks = new ArrayList<>();
    if (!RecordedRun.version().equals(run.program())) {
      remarks.add(
          Phrase.of(
              "it was recorded by version %s, and flown again by version %s",
              run.program(), RecordedRun.version()));
    }
    if (run.ended().isEmpty()) {
      remarks.add(Phrase.of("it was cut off, and flown and compared as far as it goes"));
    }
    if (!exact()) {
      remarks.add(
          Phrase.of(
              "it does not tell all that happened since the simulation began, so that only its"
                  + " commands were flown again"));
    }
    return remarks;
  }
}
