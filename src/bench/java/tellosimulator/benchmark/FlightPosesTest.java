package tellosimulator.benchmark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.benchmark.FlightPoses.Moment;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

class FlightPosesTest {

  private static final String HEADER = "anything";

  private final FlightPoses flight = FlightPoses.read(FlightPoses.FILE);

  @Test
  void hoveringStaysWhereItIs() {
    List<Moment> hover = flight.part(FlightPart.HOVER);

    assertThat(hover).hasSize(4 * 30);
    assertThat(way(hover)).isLessThan(0.1);
  }

  @Test
  void forwardIsFlownAt50CentimetersPerSecond() {
    List<Moment> forward = flight.part(FlightPart.FORWARD);

    assertThat(forward).hasSize(4 * 30);
    assertThat(way(forward) / seconds(forward)).isCloseTo(0.5, within(0.02));
  }

  @Test
  void turningIsDoneAt55DegreesPerSecond() {
    List<Moment> turn = flight.part(FlightPart.TURN);
    double turned = 0;
    for (int i = 1; i < turn.size(); i++) {
      double step =
          turn.get(i).pose().attitude().heading() - turn.get(i - 1).pose().attitude().heading();
      turned += Math.toDegrees(Math.IEEEremainder(step, 2 * Math.PI));
    }

    assertThat(turn).hasSize(4 * 30);
    assertThat(turned / seconds(turn)).as("clockwise").isCloseTo(-55, within(2.0));
  }

  @Test
  void thePoseOfEachLineIsRead() {
    FlightPoses one =
        FlightPoses.parse("a.csv", List.of(HEADER, "turn,0.035,10,-20,80.5,120,10,-20"));

    Moment moment = one.moments().get(0);
    assertThat(moment.part()).isEqualTo(FlightPart.TURN);
    assertThat(moment.seconds()).isEqualTo(0.035);
    assertThat(moment.pose().position().distanceTo(new Vec3(0.1, -0.2, 0.805)))
        .isCloseTo(0, within(1e-9));
    Attitude attitude = moment.pose().attitude();
    assertThat(Math.toDegrees(attitude.heading())).isCloseTo(120, within(1e-9));
    assertThat(Math.toDegrees(attitude.elevation())).isCloseTo(10, within(1e-9));
    assertThat(Math.toDegrees(attitude.bank())).isCloseTo(-20, within(1e-9));
  }

  @Test
  void whatIsWrittenIsReadAgain() {
    List<Moment> again = FlightPoses.parse("again.csv", flight.lines()).moments();

    assertThat(again).hasSameSizeAs(flight.moments());
    for (int i = 0; i < again.size(); i++) {
      Moment before = flight.moments().get(i);
      assertThat(again.get(i).part()).isEqualTo(before.part());
      // half of the last digits: 0.05 mm in three directions, 0.0005 degrees
      assertThat(place(again.get(i)).distanceTo(place(before))).isLessThan(1e-4);
      assertThat(again.get(i).pose().attitude().heading())
          .isCloseTo(before.pose().attitude().heading(), within(1e-5));
    }
  }

  @Test
  void lineThatIsNoPoseIsNamed() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> FlightPoses.parse("a.csv", List.of(HEADER, "turn,0,1,2,x,4,5,6")))
        .withMessageStartingWith("a.csv:2: expected part,seconds,")
        .withMessageEndingWith("found \"turn,0,1,2,x,4,5,6\"");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> FlightPoses.parse("a.csv", List.of(HEADER, "turn,0,1")));
  }

  private static double way(List<Moment> moments) {
    return place(moments.get(0)).distanceTo(place(moments.get(moments.size() - 1)));
  }

  private static Vec3 place(Moment moment) {
    Pose pose = moment.pose();
    return pose.position();
  }

  private static double seconds(List<Moment> moments) {
    return moments.get(moments.size() - 1).seconds() - moments.get(0).seconds();
  }
}
