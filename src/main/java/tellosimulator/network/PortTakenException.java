package tellosimulator.network;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Locale;

/** An address or port that cannot be had; its message is one sentence for people. */
public final class PortTakenException extends IOException {

  private static final long serialVersionUID = 1;

  /** Why it cannot be had. */
  public enum Obstacle {
    /** Another program has the port. */
    TAKEN,
    /** An operator program probably has the port, because all of them need it. */
    TAKEN_BY_OPERATOR,
    NO_SUCH_ADDRESS,
    /** The network reaches it, but nobody asked for that. */
    OFF_LIMITS,
    /** The system refuses. */
    FORBIDDEN
  }

  private final transient InetSocketAddress address;
  private final Obstacle obstacle;

  private PortTakenException(
      InetSocketAddress address, Obstacle obstacle, String message, IOException cause) {
    super(message, cause);
    this.address = address;
    this.obstacle = obstacle;
  }

  /** What cannot be had. */
  public InetSocketAddress address() {
    return address;
  }

  /** Why it cannot be had. */
  public Obstacle obstacle() {
    return obstacle;
  }

  /**
   * Of a port that no drone needs.
   *
   * @param option with which another one is chosen
   */
  public static PortTakenException taken(
      InetSocketAddress address, String option, IOException cause) {
    return new PortTakenException(
        address,
        Obstacle.TAKEN,
        String.format(
            Locale.ROOT,
            "Port %d of %s cannot be had (%s): choose another one with %s, or 0 for a free one.",
            address.getPort(),
            address.getAddress().getHostAddress(),
            cause.getMessage(),
            option),
        cause);
  }

  /**
   * Of a port of this machine to which a real drone sends.
   *
   * @param what it sends there: {@code state}
   * @param option with which the operator program's own port is chosen
   */
  public static PortTakenException takenFromProxy(
      InetSocketAddress address, String what, String option, IOException cause) {
    return new PortTakenException(
        address,
        Obstacle.TAKEN,
        String.format(
            Locale.ROOT,
            "Port %d of %s cannot be had (%s), but the drone sends its %s there: end the program"
                + " that has it, let it take the %s at another port and say which with %s, or run"
                + " it on another machine and the proxy with --lan.",
            address.getPort(),
            address.getAddress().getHostAddress(),
            cause.getMessage(),
            what,
            what,
            option),
        cause);
  }

  static PortTakenException taken(InetSocketAddress address, IOException cause) {
    int port = address.getPort();
    String who =
        port == AddressPlan.REAL_COMMAND_PORT
            ? "probably by a drone program, which needs that port for itself"
            : "probably by a Tello simulator that is still running";
    return new PortTakenException(
        address,
        port == AddressPlan.REAL_COMMAND_PORT ? Obstacle.TAKEN_BY_OPERATOR : Obstacle.TAKEN,
        String.format(
            Locale.ROOT,
            "Port %d of %s is taken, %s: end that program, or choose another port with"
                + " --command-port.",
            port,
            address.getAddress().getHostAddress(),
            who),
        cause);
  }

  static PortTakenException noSuchAddress(InetSocketAddress address, IOException cause) {
    String host = address.getAddress().getHostAddress();
    String remedy =
        address.getAddress().isLoopbackAddress()
            ? String.format(
                Locale.ROOT,
                "add it (macOS: `sudo ifconfig lo0 alias %s up`), or use --port-per-drone",
                host)
            : "choose one of this machine's own addresses with --bind";
    return new PortTakenException(
        address,
        Obstacle.NO_SUCH_ADDRESS,
        String.format(Locale.ROOT, "This machine has no address %s: %s.", host, remedy),
        cause);
  }

  static PortTakenException offLimits(InetSocketAddress address) {
    return new PortTakenException(
        address,
        Obstacle.OFF_LIMITS,
        String.format(
            Locale.ROOT,
            "%s can be reached from the network, but the drones listen on this machine only: give"
                + " --lan to allow it, or in the window switch \"Reachable from the network\" on.",
            address.getAddress().getHostAddress()),
        new IOException("off limits"));
  }

  static PortTakenException forbidden(InetSocketAddress address, IOException cause) {
    return new PortTakenException(
        address,
        Obstacle.FORBIDDEN,
        String.format(
            Locale.ROOT,
            "Port %d of %s cannot be opened (%s): choose another port with --command-port.",
            address.getPort(),
            address.getAddress().getHostAddress(),
            cause.getMessage()),
        cause);
  }
}
