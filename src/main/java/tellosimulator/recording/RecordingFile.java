package tellosimulator.recording;

import java.nio.file.Path;

/** The text files of a recording. Each drone's film stands beside them. */
public enum RecordingFile {
  /** What is known of the flight as a whole; makes a folder a recording. */
  RUN("run.json"),
  /** Each datagram, both ways. */
  WIRE("wire.jsonl"),
  /** What happened. */
  EVENTS("events.jsonl"),
  /** Where the drones were. */
  FLIGHT("flight.csv"),
  /** What became of the goals. */
  GOALS("goals.json"),
  /** What the simulation began from, and all that came to it since. */
  INPUTS("inputs.jsonl"),
  /** The scenario as it was flown. */
  SCENARIO("scenario.yaml");

  private final String fileName;

  RecordingFile(String fileName) {
    this.fileName = fileName;
  }

  public String fileName() {
    return fileName;
  }

  /** Its path in the folder of a recording. */
  public Path in(Path folder) {
    return folder.resolve(fileName);
  }
}
