package tellosimulator.view.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.testing.SteppedDrone;

/** The window's yaw is that of the state line, from power-on and from reset. */
class FxDroneModelTest {

  private final Pose start = new Pose(Vec3.ZERO, Attitude.ofHeading(Math.toRadians(30)));
  private final SteppedDrone drone =
      SteppedDrone.of(
          SimConfig.DEFAULT.withDrones(
              List.of(DroneSetup.at(start, Product.DEFAULT, StreamPorts.DEFAULT))));
  private final FxDroneModel model = new FxDroneModel(drone.snapshot());

  @BeforeEach
  void turn() {
    drone.ask("command");
    showsYaw(0);
    drone.ask("takeoff");
    drone.ask("cw 90");
    drone.ask("land");
  }

  @Test
  void yawCountsFromTheHeadingAtPowerOn() {
    showsYaw(90);

    drone.control(new Control.Power(1, false));
    drone.control(new Control.Power(1, true));
    drone.ask("command");

    showsYaw(0);
  }

  @Test
  void yawIsZeroAgainWhereTheStartPoints() {
    drone.control(new Control.Power(1, false));
    drone.control(new Control.Power(1, true));
    drone.ask("command");

    drone.control(new Control.Reset(1));

    showsYaw(0);
    drone.ask("takeoff");
    drone.ask("ccw 40");
    showsYaw(-40);
  }

  private void showsYaw(int degrees) {
    drone.advance(0.2);
    model.update(drone.snapshot(), false);
    assertThat(Math.round(model.yawDeg())).isEqualTo(degrees);
    assertThat(drone.stateLines().get(drone.stateLines().size() - 1).text())
        .contains(";yaw:" + degrees + ";");
    assertThat(drone.ask("attitude?")).endsWith("yaw:" + degrees + ";\r\n");
  }
}
