package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import tellosimulator.files.IoReason;
import tellosimulator.json.Json;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.words.Phrase;

/**
 * Reads the files of a recording and collects remarks on missing parts. Not thread-safe; an
 * instance can be used only once.
 */
final class RecordingReader {

  private final Path folder;
  private final List<Phrase> remarks = new ArrayList<>();

  RecordingReader(Path folder) {
    this.folder = folder;
  }

  RecordedFlight read() throws UnreadableRecordingException {
    RecordedRun run = run();
    List<Track> tracks = tracks();
    if (run.realDrone().isPresent()) {
      remarkOnRealDrone(tracks);
    }
    return read(run, tracks);
  }

  /** Reads everything except the tracks. */
  RecordedFlight readCommands() throws UnreadableRecordingException {
    return read(run(), List.of());
  }

  private RecordedFlight read(RecordedRun run, List<Track> tracks) {
    List<RecordedEvent> events = new ArrayList<>();
    CommandPairing pairing = new CommandPairing();
    boolean[] told = {false};
    readLines(
        RecordingFile.EVENTS,
        line -> {
          RecordedEvent event = RecordedEvent.of(Fields.of(line));
          told[0] = true;
          pairing.take(event);
          if (!event.isOfCommand()) {
            events.add(event);
          }
        });
    if (!told[0]) {
      readLines(RecordingFile.WIRE, line -> takeFromWire(pairing, line));
    }
    return new RecordedFlight(
        run, tracks, pairing.commands(), events, goals(), scenario(), remarks);
  }

  /** Reads only the general data. */
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

  /** Suggests a recording inside a folder that is not a recording itself. */
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
    Track.Builder tracks = new Track.Builder();
    read(RecordingFile.FLIGHT, () -> FlightCsvReader.readAll(folder, tracks::add));
    return tracks.tracks();
  }

  private void remarkOnRealDrone(List<Track> tracks) {
    remarks.add(
        tracks.isEmpty()
            ? Phrase.of(
                "a real drone flew, and its program took no state lines, so that nothing is known"
                    + " of how it moved; the room is not known either")
            : Phrase.of(
                "a real drone flew: its path is summed up from the speeds in its state lines, and"
                    + " the room is not known"));
  }

  /**
   * Parses a line if it may be a command or a reply. Lines of state and video, which are the
   * majority, are not parsed.
   */
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
              .map(goal -> new RecordedGoal(goal.phrase("said", "text"), goal.number("reached")))
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

  /** Reads a file, and returns the number of damaged lines. */
  @FunctionalInterface
  private interface Reading {
    int read() throws IOException;
  }

  /** Passes the lines of a file to a sink, if the file exists. */
  private void readLines(RecordingFile file, LineReader.Sink<String> sink) {
    read(file, () -> LineReader.readAll(file.in(folder), sink));
  }

  private void read(RecordingFile file, Reading reading) {
    try {
      int refused = reading.read();
      if (refused > 0) {
        remarks.add(Phrase.of("%d lines of %s are damaged and left out", refused, file.fileName()));
      }
    } catch (IOException e) {
      remarkUnreadable(file);
    }
  }

  private void remarkUnreadable(RecordingFile file) {
    remarks.add(Phrase.of("%s cannot be read and is left out", file.fileName()));
  }
}
