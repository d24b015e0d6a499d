package tellosimulator.scenery.overlay;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.controller.FlightEvent;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimEvent;
import tellosimulator.time.SimTime;
import tellosimulator.world.Surface;

class ContactLogTest {

  private static final Vec3 HERE = new Vec3(1, 2, 0.5);

  private final ContactLog log = new ContactLog();

  @Test
  void touchesAndCrashesAreMarkedWhereTheyHappened() {
    touch(1, HERE);
    crash(2, Vec3.ZERO);

    assertThat(log.marks())
        .containsExactly(new ContactDecal(1, HERE, false), new ContactDecal(2, Vec3.ZERO, true));
  }

  @Test
  void whoRubsAlongAWallHasAMarkOnlyNowAndThen() {
    for (int i = 0; i < 100; i++) {
      touch(1, new Vec3(0.01 * i, 0, 1)); // 99 cm
    }

    assertThat(log.marks()).hasSizeBetween(9, 10);
    List<ContactDecal> before = log.marks();
    touch(1, new Vec3(0.5, 0, 1));
    assertThat(log.marks()).as("the same list").isSameAs(before);
  }

  @Test
  void aCrashWhereItTouchedIsAnotherMark() {
    touch(1, HERE);
    crash(1, HERE);

    assertThat(log.marks()).hasSize(2);
  }

  @Test
  void whoIsPutBackLeavesNoMarks() {
    touch(1, HERE);
    touch(2, HERE);

    happened(1, new FlightEvent.PutBack());
    assertThat(log.marks()).extracting(ContactDecal::drone).containsExactly(2);

    log.event(new SimEvent.RunStarted(SimTime.ZERO));
    assertThat(log.marks()).isEmpty();
  }

  @Test
  void howeverManyThereAreTheyAreBounded() {
    for (int i = 0; i < ContactLog.MOST + 50; i++) {
      touch(1, new Vec3(i, 0, 0));
    }

    assertThat(log.marks()).hasSize(ContactLog.MOST);
    assertThat(log.marks().get(0).place().x()).as("the oldest give way").isEqualTo(50);
  }

  private void touch(int drone, Vec3 place) {
    happened(drone, new FlightEvent.Touched(Surface.FLOOR, 0.3, place));
  }

  private void crash(int drone, Vec3 place) {
    happened(drone, new FlightEvent.Crashed(Surface.FLOOR, 2, 0, place));
  }

  private void happened(int drone, FlightEvent event) {
    log.event(new SimEvent.DroneFlight(SimTime.ZERO, drone, event));
  }
}
