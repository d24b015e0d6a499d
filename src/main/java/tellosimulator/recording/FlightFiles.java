package tellosimulator.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.goal.Goal;
import tellosimulator.json.Json;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioDocument;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.time.WallTime;

/** The files of one recording. For the writer's thread. */
final class FlightFiles implements AutoCloseable {

  private final Path folder;
  private final RecordingFolder.Disk disk;
  private final RunText run;
  private final WallTime begun;
  private final List<TextFile> open = new ArrayList<>();
  private final TextFile wire;
  private Optional<TextFile> events = Optional.empty();
  private Optional<TextFile> table = Optional.empty();

  /** Empty if not all inputs are known. */
  private Optional<TextFile> inputs = Optional.empty();

  /**
   * Begins those that each recording has: what was on the wire, and what is known of the flight.
   *
   * @throws IOException if one cannot be written
   */
  FlightFiles(Path folder, RecordingFolder.Disk disk, RunText run, WallTime begun)
      throws IOException {
    this.folder = folder;
    this.disk = disk;
    this.run = run;
    this.begun = begun;
    writeAnew(RecordingFile.RUN, run.begun());
    wire = open(RecordingFile.WIRE);
  }

  /**
   * Begins those that only a simulation can have, too: what happened, and where the drones were.
   *
   * @param flown the scenario as it is at the takeoff
   * @param history what the flight follows from
   * @throws IOException if one cannot be written; then all are closed
   */
  void addTruth(Scenario flown, ScenarioDocument document, InputHistory history)
      throws IOException {
    try {
      if (history.complete()) {
        TextFile known = open(RecordingFile.INPUTS);
        open.add(0, open.remove(open.size() - 1)); // first, so that it is never behind the others
        known.row().raw(history.text());
        inputs = Optional.of(known);
      }
      events = Optional.of(open(RecordingFile.EVENTS));
      TextFile rows = open(RecordingFile.FLIGHT);
      rows.row().raw(RecordingFormat.HEADER);
      table = Optional.of(rows);
      ScenarioFile.write(document.changedTo(flown, folder), RecordingFile.SCENARIO.in(folder));
    } catch (IOException | RuntimeException e) {
      closeQuietly();
      throw e;
    }
  }

  private TextFile open(RecordingFile file) throws IOException {
    TextFile opened = new TextFile(file.in(folder), disk);
    open.add(opened);
    return opened;
  }

  Path folder() {
    return folder;
  }

  WallTime begun() {
    return begun;
  }

  TextFile wire() {
    return wire;
  }

  /** Of a simulation alone. */
  TextFile events() {
    return events.orElseThrow();
  }

  /** Of a simulation alone. */
  TextFile table() {
    return table.orElseThrow();
  }

  /** Adds an input. */
  void input(String line) throws IOException {
    if (inputs.isPresent()) {
      inputs.get().row().raw(line);
      flushIfLarge(inputs.get());
    }
  }

  /** Hands the lines of a file to the system, if there are many; inputs are never behind. */
  void flushIfLarge(TextFile file) throws IOException {
    if (file.isLarge()) {
      if (inputs.isPresent()) {
        inputs.get().flush();
      }
      file.flush();
    }
  }

  /** Hands all that is written to the system. */
  void flush() throws IOException {
    for (TextFile file : open) {
      file.flush();
    }
  }

  /** Writes what is known at the end, and closes all. */
  void finish(Entry.End end, List<VideoRecorders.Kept> films) throws IOException {
    for (TextFile file : open) {
      file.close();
    }
    open.clear();
    if (!end.goals().progress().challenge().goals().isEmpty()) {
      writeAnew(RecordingFile.GOALS, Json.text(goals(end.goals())));
    }
    writeAnew(RecordingFile.RUN, run.ended(end, films));
  }

  private static List<Object> goals(GoalResult result) {
    List<Object> goals = new ArrayList<>();
    List<Goal> asked = result.progress().challenge().goals();
    for (int i = 0; i < asked.size(); i++) {
      Map<String, Object> goal = new LinkedHashMap<>();
      OptionalDouble reached = result.reached(i);
      goal.put("text", asked.get(i).phrase().english());
      goal.put("reached", reached.isPresent() ? Json.rounded(reached.getAsDouble()) : null);
      goals.add(goal);
    }
    return goals;
  }

  /** Writes all of a file, or leaves it as it was. */
  private void writeAnew(RecordingFile file, String text) throws IOException {
    Path beside = folder.resolve("." + file.fileName());
    try (OutputStream out = disk.create(beside)) {
      out.write((text + "\n").getBytes(StandardCharsets.US_ASCII));
    }
    Files.move(
        beside,
        file.in(folder),
        StandardCopyOption.ATOMIC_MOVE,
        StandardCopyOption.REPLACE_EXISTING);
  }

  private void closeQuietly() {
    try {
      close();
    } catch (IOException e) {
      // there is a better reason already
    }
  }

  /** Closes all as they are, as if the recording was cut off here. */
  @Override
  public void close() throws IOException {
    List<TextFile> files = List.copyOf(open);
    open.clear();
    IOException failure = null;
    for (TextFile file : files) {
      try {
        file.close();
      } catch (IOException e) {
        failure = e;
      }
    }
    if (failure != null) {
      throw failure;
    }
  }
}
