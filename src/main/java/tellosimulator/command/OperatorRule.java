package tellosimulator.command;

import java.net.InetAddress;
import java.util.Optional;

/**
 * The rule that determines who may operate a drone. Immutable.
 *
 * @param exclusive whether commands other than read commands are accepted only from the operator's
 *     host; false matches the real drone, which accepts commands from every host in its network
 * @param only the only host that may become operator; empty for any host
 */
public record OperatorRule(boolean exclusive, Optional<InetAddress> only) {

  /**
   * The first host that sends {@code command} operates the drone until the drone becomes free
   * again.
   */
  public static final OperatorRule FIRST = new OperatorRule(true, Optional.empty());

  /**
   * Every host may send commands. State and video go to the first host that sends {@code command}.
   */
  public static final OperatorRule ANYONE = new OperatorRule(false, Optional.empty());

  /** Returns a rule that lets only one host operate the drone. */
  public static OperatorRule only(InetAddress host) {
    return new OperatorRule(true, Optional.of(host));
  }

  /** Whether this rule names a host as the only one that may become operator. */
  public boolean names(InetAddress host) {
    return only.isPresent() && only.get().equals(host);
  }

  /** Whether a host may become the operator of a drone without an operator. */
  public boolean accepts(InetAddress host) {
    return only.isEmpty() || names(host);
  }
}
