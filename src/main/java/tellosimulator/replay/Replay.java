package tellosimulator.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.recording.InitialConditions;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedInput;
import tellosimulator.recording.RecordedInputs;
import tellosimulator.recording.RecordedRun;
import tellosimulator.recording.RecordingFile;
import tellosimulator.recording.RecordingFolder;
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

  /**
   * How long a recording may go on after its last line [s]. Decided: twice the silence after which
   * the recording of a real drone ends.
   */
  private static final double LONGEST_REST = 120;

  /** Files that tell how far a recording goes. */
  private static final List<RecordingFile> LAST_LINES =
      List.of(RecordingFile.WIRE, RecordingFile.EVENTS, RecordingFile.FLIGHT);

  private final Path folder;
  private final RecordedRun run;
  private final List<Phrase> outlineRemarks;
  private final InitialConditions start;
  private final Scenario scenario;

  /** The last moment of which a line tells [s]. */
  private final double lastLine;

  /** Commands that were sent; empty if all inputs are kept. */
  private final Optional<List<RecordedInput>> commands;

  private Replay(
      Path folder,
      RecordedFlight outline,
      InitialConditions start,
      Optional<List<RecordedInput>> commands)
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
  boolean exact() {
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
    return flown(into).folder;
  }

  /**
   * What was flown.
   *
   * @param damaged inputs that could not be read
   */
  private record Flown(Path folder, int damaged) {}

  private Flown flown(RecordingFolder into) throws IOException {
    RepeatedFlight flight = new RepeatedFlight(start, run.setting().scenario(), scenario, into);
    SimTime end = end();
    if (commands.isPresent()) {
      Iterator<RecordedInput> iterator = commands.get().iterator();
      Path made =
          flight.fly(
              () -> iterator.hasNext() ? Optional.of(iterator.next()) : Optional.empty(), end);
      return new Flown(made, 0);
    }
    try (RecordedInputs inputs = RecordedInputs.open(folder).orElseThrow()) {
      Path made = flight.fly(inputs::next, end);
      return new Flown(made, inputs.damaged());
    }
  }

  /** The end of the step after which nothing was recorded any more. */
  private SimTime end() {
    double end = ended().orElse(lastLine);
    return new SimTime(Math.round(end / SimTime.STEP) * SimTime.STEP_NANOS);
  }

  /** The end that is told [s]; empty if there is none, or none that can be. */
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
   * Flies it again, and says where both recordings differ.
   *
   * @param into where there will be a folder for it
   * @throws IOException as {@link #fly}
   */
  public Repetition repeat(RecordingFolder into) throws IOException {
    Flown again = flown(into);
    return new Repetition(
        again.folder,
        Difference.between(folder, again.folder, ended().isEmpty()),
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
    if (!exact() && RecordedInputs.areKept(folder)) {
      remarks.add(
          Phrase.of(
              "this version cannot read what it begins from, so that only its commands were flown"
                  + " again"));
    } else if (!exact()) {
      remarks.add(
          Phrase.of(
              "it does not tell all that happened since the simulation began, so that only its"
                  + " commands were flown again"));
    }
    return remarks;
  }
}
