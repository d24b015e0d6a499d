package tellosimulator.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.junit.TelloAssertions.assertThat;
import static tellosimulator.junit.Times.times;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** The code in docs/testing.md: this class contains and runs each block of the page. */
class TestingPageTest {

  private static final Pattern BLOCK = Pattern.compile("(?s)```java\\R(.*?)```");

  @Test
  void eachBlockOfThePageStandsHere() throws IOException {
    String here =
        squeezed(
            Files.readString(
                Path.of("src", "test", "java", "tellosimulator", "junit", "TestingPageTest.java")));
    String page = Files.readString(Path.of("docs", "testing.md"));

    List<MatchResult> blocks = BLOCK.matcher(page).results().toList();
    assertThat(blocks).hasSizeGreaterThan(6);
    assertThat(blocks).allSatisfy(block -> assertThat(here).contains(squeezed(block.group(1))));
  }

  private static String squeezed(String code) {
    return code.strip().replaceAll("\\s+", " ");
  }

  /** A program's drone. */
  private record Tello(InetSocketAddress drone, DatagramSocket socket) implements AutoCloseable {

    Tello(InetSocketAddress drone, Duration timeout) throws IOException {
      this(drone, new DatagramSocket());
      socket.setSoTimeout((int) timeout.toMillis());
    }

    String send(String command) throws IOException {
      byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
      socket.send(new DatagramPacket(bytes, bytes.length, drone));
      DatagramPacket reply = new DatagramPacket(new byte[1024], 1024);
      socket.receive(reply);
      return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII);
    }

    @Override
    public void close() {
      socket.close();
    }
  }

  /** Takes off, and does not do so again if only the reply was lost. */
  private record CarefulPilot(Tello tello) {

    void takeOff() throws IOException {
      tello.send("command");
      try {
        tello.send("takeoff");
      } catch (SocketTimeoutException e) {
        if (height() == 0) {
          tello.send("takeoff");
        }
      }
    }

    private int height() throws IOException {
      while (true) {
        try {
          return Integer.parseInt(tello.send("height?").replaceAll("\\D", ""));
        } catch (SocketTimeoutException e) {
          // lost, too
        }
      }
    }
  }

  @Nested
  @TelloTest
  class FirstFlightTest {

    @Test
    void fliesOneMeterForward(SimulatedDrone drone) throws IOException {
      try (Tello tello = new Tello(drone.address(), Duration.ofSeconds(10))) {
        tello.send("command");
        tello.send("takeoff");
        tello.send("forward 100");
        tello.send("land");
      }

      assertThat(drone).hasLanded().isWithin(5).of(100, 0);
    }
  }

  @Nested
  @TelloTest
  class Recipes {

    @Test
    void aLostReplyDoesNotTakeOffTwice(SimulatedDrone drone, TelloSimulation simulation)
        throws IOException {
      simulation.faults().inject("loss replies 100% after \"takeoff\" for 3.05s");

      try (Tello tello = new Tello(drone.address(), Duration.ofSeconds(5))) {
        new CarefulPilot(tello).takeOff(); // looks at the height before it tries again
      }

      assertThat(drone).isFlying();
      drone.journal().verify(times(1), "takeoff");
    }

    @TelloTest(scenario = "gate-race")
    void fliesTheRace(SimulatedDrone drone, TelloSimulation simulation) throws IOException {
      try (Tello tello = new Tello(drone.address(), Duration.ofSeconds(10))) {
        for (String command : List.of("command", "takeoff", "up 70", "forward 200", "up 50")) {
          tello.send(command);
        }
        assertThat(drone).visited("A").neverTouchedAnything();
        assertThat(simulation.goals().open()).hasSize(3);

        for (String command : List.of("forward 150", "down 30", "left 250", "land")) {
          tello.send(command);
        }
      }
      simulation.awaitGoals();
    }

    @TelloTest(scenario = "wall-pad", timeFactor = "1")
    void theFilmBegins(SimulatedDrone drone) throws IOException {
      try (DatagramSocket film = new DatagramSocket(drone.videoPort());
          Tello tello = new Tello(drone.address(), Duration.ofSeconds(10))) {
        film.setSoTimeout(60_000);
        tello.send("command");
        tello.send("streamon");

        DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
        film.receive(packet);

        assertThat(packet.getLength()).isPositive();
      }
    }

    @TelloTest(drones = 3)
    void allTakeOff(TelloSimulator simulator) throws IOException {
      for (SimulatedDrone drone : simulator.drones()) {
        try (Tello tello = new Tello(drone.address(), Duration.ofSeconds(10))) {
          tello.send("command");
          tello.send("takeoff");
        }
      }

      for (SimulatedDrone drone : simulator.drones()) {
        assertThat(drone).isFlying().stayedWithin(5);
      }
    }

    @NeedsTool(Tool.PYTHON)
    @TelloTest
    void aPythonProgramFlies(SimulatedDrone drone) {
      drone
          .program("python3", "fly.py", "{host}", "{commandPort}")
          .in(Path.of("examples", "testing"))
          .within(Duration.ofSeconds(30))
          .run();

      assertThat(drone).hasLanded();
    }

    @Test
    void withoutJUnit() throws IOException {
      try (TelloSimulator simulator = TelloSimulator.start("slalom")) {
        SimulatedDrone drone = simulator.drone();
        try (Tello tello = new Tello(drone.address(), Duration.ofSeconds(10))) {
          tello.send("command");
          tello.send("takeoff");
        }
        if (drone.truth().height() < 20) {
          throw new IllegalStateException(simulator.explanation());
        }
      }
    }
  }
}
