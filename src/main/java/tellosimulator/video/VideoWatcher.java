package tellosimulator.video;

/** Receives a drone's pictures as they are rendered. */
public interface VideoWatcher {

  /** Whether pictures must be encoded even if no operator requests them. Thread-safe. */
  default boolean needsStream() {
    return false;
  }

  /**
   * Whether pictures must be rendered for this watcher. If not, it receives only pictures that are
   * rendered anyway. Thread-safe.
   */
  default boolean needsPictures() {
    return true;
  }

  /**
   * Called with each new picture on the drone's video thread. Must be quick, and must not throw.
   */
  void filmed(FilmedPicture picture);
}
