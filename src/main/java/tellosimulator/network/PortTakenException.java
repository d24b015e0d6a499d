package tellosimulator.network;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Locale;

/** Thrown if an address or port cannot be opened. The message is one sentence for users. */
public final class PortTakenException extends IOException {

  private static final long serialVersionUID = 1;

  /** The reason why an address or port cannot be opened. */
  public enum Obstacle {
    /** Another program uses the port. */
    TAKEN,
    /**
     * The port is probably used by an operator program, because every operator program needs this
     * port.
     */
    TAKEN_BY_OPERATOR,
    /** The address does not belong to this machine. */
    NO_SUCH_ADDRESS,
    /** The address is reachable from the network, but was not requested explicitly. */
    OFF_LIMITS,
    /** The system denies access to the port. */
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

  /** Returns the address that cannot be opened. */
  public InetSocketAddress address() {
    return address;
  }

  /** Returns the reason why the address cannot be opened. */
  public Obstacle obstacle() {
    return obstacle;
  }

  /**
   * Creates an exception for a port other than a drone's command port.
   *
   * @param option the option that selects another port
   */
  public static PortTakenException taken(
      InetSocketAddress address, String option, IOException cause) {
    return new PortTakenException(
        address,
        Obstacle.TAKEN,
        String.format(
            Locale.ROOT,
            "Port %d of %s is not available (%s): choose another one with %s, or 0 for a free one.",
            address.getPort(),
            address.getAddress().getHostAddress(),
            cause.getMessage(),
            option),
        cause);
  }

  /**
   * Creates an exception for a port of this machine to which a real drone sends.
   *
   * @param what the data that the drone sends there, such as {@code state}
   * @param option the option that selects the operator program's own port
   */
  public static PortTakenException takenFromProxy(
      InetSocketAddress address, String what, String option, IOException cause) {
    return new PortTakenException(
        address,
        Obstacle.TAKEN,
        String.format(
            Locale.ROOT,
            "Port %d of %s is not available (%s), but the drone sends its %s there: end the program"
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
