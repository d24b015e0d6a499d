package tellosimulator.network;

/** What is known when nothing comes to drones that are on. */
public enum Silence {
  /** A program has the port that operator programs have, so one has probably begun. */
  PROGRAM_ELSEWHERE,
  /** Nothing but that. */
  NOTHING_CAME
}
