package tellosimulator.testing;

import java.util.function.Consumer;
import tellosimulator.command.DronePort;
import tellosimulator.fault.LinkDirection;

/** Ports without a network, for tests that read what a drone sends as texts. */
public final class TextPort {

  private TextPort() {}

  /** Returns a port that passes on replies, and drops state lines. */
  public static DronePort replies(Consumer<String> replies) {
    return of(replies, line -> {});
  }

  /** Returns a port that passes on replies and state lines. */
  public static DronePort of(Consumer<String> replies, Consumer<String> states) {
    return datagram ->
        (datagram.direction() == LinkDirection.STATE ? states : replies).accept(datagram.text());
  }
}
