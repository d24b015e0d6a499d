package tellosimulator.sim;

import java.net.InetSocketAddress;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.words.Phrase;

/**
 * An input to a simulation from outside. The configuration and the inputs completely determine a
 * simulation: the same inputs between the same steps have the same effects. Immutable.
 */
public sealed interface SimInput {

  /** An input to one drone. */
  sealed interface ForDrone extends SimInput {
    /** Returns the number of the drone, from 1. */
    int drone();
  }

  /**
   * A datagram from an operator program.
   *
   * @param drone the number of the receiving drone, from 1
   * @param bytes the content, which must not be modified
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  record Datagram(int drone, Peer peer, byte[] bytes) implements ForDrone, Inbox.Item {

    /** Returns the bytes as a text, one character per byte (ISO-8859-1). */
    public String text() {
      return WireText.decode(bytes);
    }
  }

  /** A control, for example by the simulation's user. */
  record Act(Control control) implements SimInput {}

  /**
   * The network reported a destination of a drone as unreachable.
   *
   * @param drone the number of the drone, from 1
   */
  record Unreachable(int drone, InetSocketAddress destination) implements ForDrone {}

  /**
   * The network layer rejected datagrams before they reached the simulation.
   *
   * @param drone the number of the drone to which they were sent, from 1
   * @param host the host that sent them
   */
  record Dropped(int drone, String host, long count, Phrase reason) implements ForDrone {}

  /**
   * A report that the machine was too slow.
   *
   * @param seconds the time skipped since the previous report [simulated s]
   * @param all the time skipped since the start [simulated s]
   */
  record TimeLost(double seconds, double all) implements SimInput {}
}
