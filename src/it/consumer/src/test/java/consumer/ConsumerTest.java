package consumer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static tellosimulator.junit.Times.times;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import tellosimulator.junit.OnCrash;
import tellosimulator.junit.SimulatedDrone;
import tellosimulator.junit.TelloTest;

/** A project that has neither a window nor a logger nor AssertJ. */
@TelloTest(scenario = "gate-race", onCrash = OnCrash.ALLOW)
class ConsumerTest {

  @Test
  void fliesThroughTheFirstGate(SimulatedDrone drone) throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(20_000);
      for (String command : new String[] {"command", "takeoff", "up 70", "forward 200"}) {
        byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
        socket.send(new DatagramPacket(bytes, bytes.length, drone.address()));
        DatagramPacket reply = new DatagramPacket(new byte[100], 100);
        socket.receive(reply);
        assertEquals("ok", new String(reply.getData(), 0, 2, StandardCharsets.US_ASCII));
      }
    }

    assertTrue(drone.truth().flying());
    assertEquals("[A]", drone.truth().visited().toString());
    drone.journal().verify(times(1), "takeoff");
    assertThrows(ClassNotFoundException.class, () -> Class.forName("javafx.application.Platform"));
    assertThrows(ClassNotFoundException.class, () -> Class.forName("org.assertj.core.api.Assert"));
  }
}
