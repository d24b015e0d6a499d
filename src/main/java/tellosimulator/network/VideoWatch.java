package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Detects that a program on this machine listens for a drone's video that no program has requested.
 * Like {@link SilenceWatch}, it only probes whether the port is free. Not thread-safe.
 */
final class VideoWatch {

  /**
   * Number of checks, one per second, that must find a listener before the listener is reported.
   * Decided.
   */
  static final int LOOKS_WITH_LISTENER = 8;

  /**
   * Number of checks after which the port is no longer probed, because a program may need it later.
   * Decided.
   */
  static final int LOOKS = 45;

  private final Supplier<Optional<InetSocketAddress>> unasked;
  private final Runnable listener;
  private int looks;
  private int taken;

  /**
   * Creates a watch.
   *
   * @param unasked supplies the video address of a drone that is operated from this machine, but
   *     whose video was not requested
   * @param listener called at most once, on the thread that calls {@link #look}
   */
  VideoWatch(Supplier<Optional<InetSocketAddress>> unasked, Runnable listener) {
    this.unasked = unasked;
    this.listener = listener;
  }

  /** Performs one check. Must be called once per second. */
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
