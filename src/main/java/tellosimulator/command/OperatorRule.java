package tellosimulator.command;

import java.net.InetAddress;
import java.util.Optional;

/**
 * Who may operate a drone. Immutable; for any thread.
 *
 * @param exclusive whether only the operator's host may steer; false is what the real drone does,
 *     where everybody in its network steers
 * @param only the one host that may become operator; empty for any
 */
public record OperatorRule(boolean exclusive, Optional<InetAddress> only) {

  /** The host that first sends {@code command}, until the drone is free again. */
  public static final OperatorRule FIRST = new OperatorRule(true, Optional.empty());

  /** Everybody steers; state and video go to the host that first sends {@code command}. */
  public static final OperatorRule ANYONE = new OperatorRule(false, Optional.empty());

  /** One host alone. */
  public static OperatorRule only(InetAddress host) {
    return new OperatorRule(true, Optional.of(host));
  }

  /** Whether this is the one host that may become operator. */
  public boolean names(InetAddress host) {
    return only.isPresent() && only.get().equals(host);
  }

  /** Whether a host may become operator of a drone that is free. */
  public boolean accepts(InetAddress host) {
    return only.isEmpty() || names(host);
  }
}
