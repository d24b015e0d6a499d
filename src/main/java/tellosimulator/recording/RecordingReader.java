package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import tellosimulator.files.IoReason;
import tellosimulator.json.Json;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.words.Phrase;

/** Reads the files of a recording, and notes what is missing. For one thread, once. */
final class RecordingReader {

  private final Path folder;
  private final List<Phrase> remarks = new ArrayList<>();

  RecordingReader(Path folder) {
    this.folder = folder;
  }

  RecordedFlight read() throws UnreadableRecordingException {
    RecordedRun run = run();
    List<Track> tracks = run.realDrone().isPresent() ? estimatedTracks() : tracks();
    List<RecordedEvent> events = new ArrayList<>();
    CommandPairing pairing = new CommandPairing();
    readLines(RecordingFile.EVENTS, line -> events.add(RecordedEvent.of(Fields.of(line))));
    if (events.isEmpty()) {
      readLines(RecordingFile.WIRE, line -> takeFromWire(pairing, line));
    } else {
      events.forEach(pairing::take);
    }
    return new RecordedFlight(
        run, tracks, pairing.commands(), events, goals(), scenario(), remarks);
  }

  /** What is known of it as a whole. */
  RecordedFlight readOutline() throws UnreadableRecordingException {
    return new RecordedFlight(
        run(), List.of(), List.of(), List.of(), List.of(), scenario(), remarks);
  }

  private RecordedRun run() throws UnreadableRecordingException {
    Path file = RecordingFile.RUN.in(folder);
    if (!Files.isDirectory(folder)) {
      throw new UnreadableRecordingException(
          Files.exists(folder)
              ? folder + " is no folder; name the folder of a recording."
              : "There is no folder " + folder + "; name the folder of a recording.");
    }
    if (!RecordingFile.RUN.exists(folder)) {
      throw new UnreadableRecordingException(
          folder
              + " is no recording, because there is no "
              + RecordingFile.RUN.fileName()
              + " in it"
              + nearby()
              + ".");
    }
    try {
      Fields fields = Fields.of(RecordingFile.RUN.read(folder));
      RecordedRun run = RecordedRun.of(fields);
      remarkOn(run, fields.whole("format").orElse(RecordedRun.FORMAT));
      return run;
    } catch (IllegalArgumentException e) {
      throw new UnreadableRecordingException(
          file + " is damaged, so that the recording cannot be read.", e);
    } catch (IOException e) {
      throw new UnreadableRecordingException(
          file + " cannot be read: " + IoReason.ofReading(e) + ".", e);
    }
  }

  private void remarkOn(RecordedRun run, int format) {
    if (format > RecordedRun.FORMAT) {
      remarks.add(
          Phrase.of(
              "it is from a newer version of the program (format %d, here %d); what this version"
                  + " does not know is not shown",
              format, RecordedRun.FORMAT));
    }
    if (run.ended().isEmpty()) {
      remarks.add(
          Phrase.of(
              "the recording was cut off before the flight was over; what was written until then"
                  + " is shown"));
    }
  }

  /** The recordings in a folder that is none itself, so that one can be named. */
  private String nearby() {
    try (Stream<Path> below = Files.list(folder)) {
      return below
          .filter(each -> Files.isRegularFile(RecordingFile.RUN.in(each)))
          .sorted()
          .findFirst()
          .map(first -> "; name one of the recordings in it, such as " + first)
          .orElse("");
    } catch (IOException e) {
      return "";
    }
  }

  private List<Track> tracks() {
    FlightCsvReader[] table = new FlightCsvReader[1];
    readLines(
        RecordingFile.FLIGHT,
        line -> {
          if (table[0] == null) {
            table[0] = new FlightCsvReader(line);
          } else {
            table[0].take(line);
          }
        });
    return table[0] == null ? List.of() : table[0].tracks();
  }

  /** Those of a real drone, of which nobody knows where it was. */
  private List<Track> estimatedTracks() {
    EstimatedTrack estimated = new EstimatedTrack();
    readLines(
        RecordingFile.WIRE,
        line -> {
          if (line.contains("\"state\"")) {
            estimated.take(Fields.of(line));
          }
        });
    List<Track> tracks = estimated.tracks();
    remarks.add(
        tracks.isEmpty()
            ? Phrase.of(
                "a real drone flew, and its program took no state lines, so that nothing is known"
                    + " of how it moved; the room is not known either")
            : Phrase.of(
                "a real drone flew: its path is summed up from the speeds in its state lines, and"
                    + " the room is not known"));
    return tracks;
  }

  /** State and video are most of the wire; they are not looked into. */
  private static void takeFromWire(CommandPairing pairing, String line) {
    if (line.contains("\"command\"") || line.contains("\"reply\"")) {
      pairing.take(Fields.of(line));
    }
  }

  private List<RecordedGoal> goals() {
    if (!RecordingFile.GOALS.exists(folder)) {
      return List.of();
    }
    try {
      return Json.value(RecordingFile.GOALS.read(folder)) instanceof List<?> items
          ? Fields.objects(items).stream()
              .map(goal -> new RecordedGoal(goal.text("text"), goal.number("reached")))
              .toList()
          : List.of();
    } catch (IllegalArgumentException | IOException e) {
      remarkUnreadable(RecordingFile.GOALS);
      return List.of();
    }
  }

  private Optional<Scenario> scenario() {
    if (!RecordingFile.SCENARIO.exists(folder)) {
      return Optional.empty();
    }
    try {
      return Optional.of(ScenarioFile.read(RecordingFile.SCENARIO.in(folder)));
    } catch (ScenarioException e) {
      remarkUnreadable(RecordingFile.SCENARIO);
      return Optional.empty();
    }
  }

  /**
   * Hands the lines of a file on, if there is one.
   *
   * @param consumer refuses a line by an {@code IllegalArgumentException}
   */
  private void readLines(RecordingFile file, Consumer<String> consumer) {
    int refused = 0;
    try (LineReader reader = new LineReader(file.in(folder))) {
      for (Optional<String> line = reader.next(); line.isPresent(); line = reader.next()) {
        try {
          consumer.accept(line.get());
        } catch (IllegalArgumentException e) {
          refused++;
        }
      }
    } catch (IOException e) {
      remarkUnreadable(file);
    }
    if (refused > 0) {
      remarks.add(Phrase.of("%d lines of %s are damaged and left out", refused, file.fileName()));
    }
  }

  private void remarkUnreadable(RecordingFile file) {
    remarks.add(Phrase.of("%s cannot be read and is left out", file.fileName()));
  }
}
