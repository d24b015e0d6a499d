package tellosimulator.launcher;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.testing.Jvm;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/**
 * Tests that programs find a socket that repeats what it receives at the address of a real drone.
 */
@Tag("process")
@Timeout(120)
class ShimNetworkTest {

  /** The simulated drone. */
  private final DatagramSocket echo;

  private ShimNetwork network;

  ShimNetworkTest() throws IOException {
    echo = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
  }

  @BeforeEach
  void start() throws IOException {
    network = ShimNetwork.create(1);
    Thread repeating = new Thread(this::repeat, "echo");
    repeating.setDaemon(true);
    repeating.start();
  }

  private void repeat() {
    try {
      while (true) {
        DatagramPacket packet = new DatagramPacket(new byte[100], 100);
        echo.receive(packet);
        echo.send(packet);
      }
    } catch (IOException e) {
      // closed at the end of the test
    }
  }

  @AfterEach
  void end() {
    echo.close();
    network.close();
  }

  private Map<String, String> variables() throws IOException {
    return network.variables("ready: drone 1 at 127.0.0.1:" + echo.getLocalPort());
  }

  private String printed(ProcessBuilder program) throws IOException, InterruptedException {
    program.environment().putAll(variables());
    Process process = program.start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    String errors = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(errors).isZero();
    return text;
  }

  @Test
  @NeedsTool(Tool.PYTHON)
  void socketsOfPythonReachTheDrone() throws Exception {
    String program =
        """
        import socket
        s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        s.bind(("192.168.10.2", 0))
        drone = ("192.168.10.1", 8889)
        s.sendto(b"1", drone)
        print(s.recvfrom(10))
        s.sendto(b"2", 0, drone)
        buffer = bytearray(1)
        print(s.recvfrom_into(buffer), bytes(buffer))
        s.sendmsg([b"3"], [], 0, drone)
        print(s.recvmsg(10)[0::3])
        s.sendmsg([b"3"], [], 0, drone)
        print(s.recvmsg_into([buffer])[0::3])
        s.connect(drone)
        s.send(b"4")
        print(s.recv(10), s.getpeername())
        """;

    assertThat(printed(Tool.PYTHON.command("-c", program)))
        .isEqualToNormalizingNewlines(
            """
            (b'1', ('192.168.10.1', 8889))
            (1, ('192.168.10.1', 8889)) b'2'
            (b'3', ('192.168.10.1', 8889))
            (1, ('192.168.10.1', 8889))
            b'4' ('192.168.10.1', 8889)
            """);
  }

  @Test
  @NeedsTool(Tool.PYTHON)
  void endpointsOfAsyncioReachTheDrone() throws Exception {
    String program =
        """
        import asyncio

        async def main():
            loop = asyncio.get_running_loop()
            drone = ("192.168.10.1", 8889)
            for where in ({"remote_addr": drone}, {"local_addr": ("0.0.0.0", 0)}):
                reply = loop.create_future()

                class Operator(asyncio.DatagramProtocol):
                    def datagram_received(self, data, sender):
                        reply.set_result((data, sender))

                transport, _ = await loop.create_datagram_endpoint(Operator, **where)
                transport.sendto(b"1", None if "remote_addr" in where else drone)
                print(await reply)
                transport.close()

        asyncio.run(main())
        """;

    assertThat(printed(Tool.PYTHON.command("-c", program)))
        .isEqualToNormalizingNewlines("(b'1', ('192.168.10.1', 8889))\n".repeat(2));
  }

  @Test
  @NeedsTool(Tool.NODE)
  void socketsOfNodeReachTheDrone() throws Exception {
    String program =
        """
        const socket = require('dgram').createSocket('udp4');
        socket.bind(0, '192.168.10.2');
        socket.once('message', (first, sender) => {
          console.log(first.toString(), sender.address, sender.port);
          socket.once('message', (second) => {
            console.log(second.toString());
            socket.connect(8889, '192.168.10.1', () => {
              console.log(socket.remoteAddress().address);
              socket.close();
            });
          });
          socket.send('2', 0, 1, 8889, '192.168.10.1');
        });
        socket.send('1', 8889, '192.168.10.1');
        """;

    assertThat(printed(Tool.NODE.command("-e", program)))
        .isEqualTo("1 192.168.10.1 8889\n2\n192.168.10.1\n");
  }

  @Test
  void socketsOfJavaReachTheDrone() throws Exception {
    String printed = printed(Jvm.process(Jvm.commandOf(Operator.class)));

    assertThat(printed)
        .isEqualToNormalizingNewlines(
            """
            /192.168.10.1:8889 1
            /192.168.10.1:8889 i
            no reply within 10 ms
            /192.168.10.1:8889 2
            """);
  }

  /** Sends a datagram from an unconnected socket, and another one from a connected socket. */
  static final class Operator {

    private static final InetSocketAddress DRONE = new InetSocketAddress("192.168.10.1", 8889);

    public static void main(String[] arguments) throws IOException {
      try (DatagramSocket socket = new DatagramSocket()) {
        socket.send(new DatagramPacket("1".getBytes(StandardCharsets.US_ASCII), 1, DRONE));
        System.out.println(reply(socket));
        Thread.currentThread().interrupt(); // must not close the socket
        socket.send(new DatagramPacket("i".getBytes(StandardCharsets.US_ASCII), 1, DRONE));
        Thread.interrupted();
        System.out.println(reply(socket));
        socket.setSoTimeout(10);
        try {
          System.out.println(reply(socket));
        } catch (java.net.SocketTimeoutException e) {
          System.out.println("no reply within " + socket.getSoTimeout() + " ms");
        }
      }
      try (DatagramSocket socket = new DatagramSocket()) {
        socket.connect(DRONE);
        socket.send(new DatagramPacket("2".getBytes(StandardCharsets.US_ASCII), 1));
        System.out.println(reply(socket));
      }
    }

    private static String reply(DatagramSocket socket) throws IOException {
      DatagramPacket packet = new DatagramPacket(new byte[10], 10);
      socket.receive(packet);
      String text = new String(packet.getData(), 0, packet.getLength(), StandardCharsets.US_ASCII);
      return packet.getSocketAddress() + " " + text;
    }
  }

  @Test
  void eachDroneOfASwarmHasItsOwnAddress() throws IOException {
    try (ShimNetwork swarm = ShimNetwork.create(2)) {
      String ready = "ready: drone 1 at 127.0.0.1:8879; drone 2 at 127.0.0.1:8880";

      assertThat(swarm.variables(ready))
          .containsEntry(
              ShimNetwork.VARIABLE,
              "192.168.10.11:8889=127.0.0.1:8879,192.168.10.12:8889=127.0.0.1:8880")
          .containsEntry("TELLO_PORT", "8879");
      assertThatThrownBy(() -> swarm.variables("ready: drone 1 at 127.0.0.1:8879"))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("should report 2 drones");
      assertThat(swarm.program(List.of("fly"), Optional.empty())).endsWith("fly");
    }
  }
}
