package tellosimulator.network;

/** Why nothing comes to drones that are on, or from them, as far as that is known. */
public enum Silence {
  /** A program has the port that operator programs have, so one has probably begun. */
  PROGRAM_ELSEWHERE,
  /** Nothing but that. */
  NOTHING_CAME,
  /** A program listens for video, but none has asked for it. */
  VIDEO_NOT_ASKED
}
