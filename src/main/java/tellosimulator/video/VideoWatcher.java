package tellosimulator.video;

/** Sees a drone's pictures as they are made. */
public interface VideoWatcher {

  /** Whether the pictures are to be encoded even while no operator wants them. For any thread. */
  default boolean needsStream() {
    return false;
  }

  /**
   * Whether pictures are to be made for it; otherwise it sees only those that others want. For any
   * thread.
   */
  default boolean needsPictures() {
    return true;
  }

  /** A picture was made. Called on the drone's video thread: it must be quick, and not throw. */
  void filmed(FilmedPicture picture);
}
