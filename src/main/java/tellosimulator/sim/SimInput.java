package tellosimulator.sim;

import java.net.InetSocketAddress;
import tellosimulator.command.Peer;
import tellosimulator.words.Phrase;

/**
 * Something that comes to a simulation from outside. A simulation is what its configuration and its
 * inputs make of it: the same inputs between the same steps have the same effects. Immutable; for
 * any thread.
 */
public sealed interface SimInput {

  /** An input that comes to one drone. */
  sealed interface ForDrone extends SimInput {
    /** Its number, from 1. */
    int drone();
  }

  /**
   * An operator program sent something.
   *
   * @param drone number of the drone that it came to, from 1
   * @param text one character a byte (ISO-8859-1)
   */
  record Datagram(int drone, Peer peer, String text) implements ForDrone, Inbox.Item {}

  /** A person did something. */
  record Act(Control control) implements SimInput {}

  /**
   * The network says that nothing receives where a drone had sent something.
   *
   * @param drone its number, from 1
   */
  record Unreachable(int drone, InetSocketAddress destination) implements ForDrone {}

  /**
   * The network turned datagrams away before they came here.
   *
   * @param drone number of the drone that they came to, from 1
   * @param host who sent them
   */
  record Dropped(int drone, String host, long count, Phrase reason) implements ForDrone {}

  /**
   * People are told that the machine was too slow.
   *
   * @param seconds what was left out since they were told the last time [simulated s]
   * @param all what was left out since the start [simulated s]
   */
  record TimeLost(double seconds, double all) implements SimInput {}
}
