package tellosimulator.grade;

import java.util.Optional;
import tellosimulator.recording.FlightResult;
import tellosimulator.words.Phrase;

/**
 * A flight of a hand-in. Immutable.
 *
 * @param course the name of the course
 * @param attempt the number of the attempt, from 1
 * @param program how the program ended: {@code ended}, {@code exit N}, {@code no command}, {@code
 *     nothing handed in}, {@code not accepted}, {@code no entry file}, {@code did not build},
 *     {@code did not start}, {@code killed after N s} or another reason why it was killed, or
 *     {@link #SIMULATOR_FAILED}
 * @param time how time passed: {@code max}, or {@code real} by the wall clock
 * @param wallSeconds duration of the flight [s of real time]; the only value that differs if the
 *     flight is repeated
 * @param recording the folder of the recording, relative to that of the grades; empty if the drone
 *     did not take off
 * @param problem why there was no flight, as a sentence; empty if there was one, or {@code program}
 *     says it
 */
public record GradedFlight(
    String course,
    long seed,
    int attempt,
    FlightResult result,
    String program,
    String time,
    double wallSeconds,
    String recording,
    Optional<Phrase> problem) {

  /** Creates a flight without a problem. */
  public GradedFlight(
      String course,
      long seed,
      int attempt,
      FlightResult result,
      String program,
      String time,
      double wallSeconds,
      String recording) {
    this(course, seed, attempt, result, program, time, wallSeconds, recording, Optional.empty());
  }

  /** The file in the folder of a flight that contains the output of the program. */
  public static final String OUTPUT = "output.txt";

  /** The file in the folder of the hand-in that contains the output of the build. */
  public static final String BUILD_OUTPUT = "build.txt";

  /** Says that the flight could not be graded, for which the program is not to blame. */
  public static final String SIMULATOR_FAILED = "simulator failed";

  /** Whether the flight could not be graded, and must be flown again. */
  public boolean failed() {
    return program.equals(SIMULATOR_FAILED);
  }

  /** Returns the name of its folder within that of the hand-in; unique there. */
  public String name() {
    return name(course, seed, attempt);
  }

  static String name(String course, long seed, int attempt) {
    return course + "-" + seed + "-" + attempt;
  }

  /** Returns a copy with another result. */
  GradedFlight with(FlightResult other) {
    return new GradedFlight(
        course, seed, attempt, other, program, time, wallSeconds, recording, problem);
  }
}
