package pilot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static tellosimulator.junit.TelloAssertions.assertThat;
import static tellosimulator.junit.Times.times;

import java.io.IOException;
import java.time.Duration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tellosimulator.junit.SimulatedDrone;
import tellosimulator.junit.TelloSimulation;
import tellosimulator.junit.TelloTest;

@TelloTest
class SquareTest {

  private Tello tello;

  @BeforeEach
  void connect(SimulatedDrone drone) throws IOException {
    tello = new Tello(drone.address(), Duration.ofSeconds(10));
  }

  @AfterEach
  void disconnect() {
    tello.close();
  }

  @Test
  void itLandsWhereItBegan(SimulatedDrone drone) throws IOException {
    new Square(tello).fly(100);

    assertThat(drone).hasLanded().isWithin(10).ofStart().hasHeading(0, 2);
    assertThat(drone).stayedBelow(150).neverTouchedAnything();
    assertEquals(141, drone.truth().farthest(), 5); // the diagonal of the square [cm]
  }

  @Test
  void itStaysOnTheGroundWhenTheBatteryIsLow(SimulatedDrone drone) throws IOException {
    drone.battery(15);

    new Square(tello).fly(100);

    assertThat(drone).tookOff(times(0));
    drone.journal().never("takeoff");
  }

  @Test
  void itLandsWhenTheDroneRefusesToMove(SimulatedDrone drone, TelloSimulation simulation)
      throws IOException {
    simulation.faults().inject("no-valid-imu after \"cw 90\"");

    assertThrows(IOException.class, () -> new Square(tello).fly(100));

    assertThat(drone).hasLanded();
    drone.journal().verify(times(1), "forward");
  }
}
