package tellosimulator.network;

/**
 * The probable reason why no drone receives anything, although some drones are on, or why a program
 * receives no video.
 */
public enum Silence {
  /**
   * An operator program is probably running, but sends to another address: the port that operator
   * programs bind is in use, but no datagram has arrived.
   */
  PROGRAM_ELSEWHERE,
  /** No datagram has arrived, and no other reason is known. */
  NOTHING_CAME,
  /** A program listens for video, but no program has requested it. */
  VIDEO_NOT_ASKED
}
