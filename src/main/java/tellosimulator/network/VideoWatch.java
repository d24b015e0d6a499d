package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Notices once that a program of this machine listens for a drone's video that no program has asked
 * for. Like {@link SilenceWatch}, it tries for a moment whether the port is free. For one thread.
 */
final class VideoWatch {

  /** Looks, one a second, that find a listener before it is reported. Decided. */
  static final int LOOKS_WITH_LISTENER = 8;

  /** Looks after which it stops to try the port, which a program may want later. Decided. */
  static final int LOOKS = 45;

  private final Supplier<Optional<InetSocketAddress>> unasked;
  private final Runnable listener;
  private int looks;
  private int taken;

  /**
   * @param unasked where the video of a drone would go that is operated from this machine, and has
   *     not been asked for its video
   * @param listener is called at most once, on the thread that looks
   */
  VideoWatch(Supplier<Optional<InetSocketAddress>> unasked, Runnable listener) {
    this.unasked = unasked;
    this.listener = listener;
  }

  /** Looks once more; to be called once a second. */
  void look() {
    if (looks >= LOOKS || taken >= LOOKS_WITH_LISTENER) {
      return;
    }
    Optional<InetSocketAddress> port = unasked.get();
    looks += port.isPresent() ? 1 : 0;
    taken = port.filter(UdpPort::isTaken).isPresent() ? taken + 1 : 0;
    if (taken == LOOKS_WITH_LISTENER) {
      listener.run();
    }
  }
}
