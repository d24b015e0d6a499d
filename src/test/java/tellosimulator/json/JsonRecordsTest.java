package tellosimulator.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Wind;

class JsonRecordsTest {

  private static final Obstacle RING =
      new Obstacle(
          "ring \"1\"",
          new Shape.Ring(0.4, 0.05, 1.1),
          new Vec3(1.0 / 3, -0.0, 1e-9),
          Math.PI / 7,
          new ObstacleAppearance(
              0xff8800,
              ObstacleAppearance.Pattern.CHECKS,
              Map.of(ObstacleAppearance.Side.TOP, "a.png")));

  static List<Control> controls() {
    return List.of(
        new Control.Power(1, true),
        new Control.Reset(2),
        new Control.Release(1),
        new Control.Land(2),
        new Control.SetBattery(1, 33.3),
        new Control.SetStart(1, new Vec3(0.1, 0.7, 0), 1.0 / 3),
        new Control.Configure(1, Product.DEFAULT, new StreamPorts(1, 2)),
        new Control.PassTime(0.1),
        new Control.NewRun(
            SimConfig.DEFAULT
                .withSeed(Long.MIN_VALUE)
                .withTimeFactor(TimeFactor.MAX)
                .withFaults(
                    List.of(
                        Fault.of("loss state 20% burst 2 drone 1"),
                        Fault.of("dark drone 2 after \"curve\" for 2s")))),
        new Control.SetRoom(new Room(4.1, 5.2, 3.3)),
        new Control.Furnish(List.of(RING), List.of(MissionPad.onFloor(3, Vec3.ZERO, 0.2))),
        new Control.InjectFault(Fault.of("delay commands 20ms spread 30ms")),
        new Control.ClearFaults(),
        new Control.SetLink(LinkPreset.CROWDED),
        new Control.SetWind(new Wind(new Vec3(0.1, 0.2, 0), 0.3)),
        new Control.Decorate(Decor.DEFAULT),
        new Control.Pause(true),
        new Control.SetTimeFactor(new TimeFactor(0.1)));
  }

  @ParameterizedTest
  @MethodSource("controls")
  void whatIsReadIsWhatWasWritten(Control control) {
    String text = Json.text(JsonRecords.write(Control.class, control));

    assertThat(JsonRecords.read(Control.class, Json.value(text))).isEqualTo(control);
  }

  @Test
  void nothingElseIsMade() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> JsonRecords.read(Control.class, Map.of("type", "Runtime")));
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                JsonRecords.read(
                    Control.class, Map.of("type", "SetBattery", "drone", 1L, "percent", 101.0)));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> JsonRecords.socketAddress("example.com:80"));
  }
}
