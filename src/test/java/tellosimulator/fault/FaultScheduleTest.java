package tellosimulator.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import tellosimulator.time.SimTime;

class FaultScheduleTest {

  private final List<String> told = new ArrayList<>();

  @Test
  void whatActsAtOnceActsFromTheStart() {
    FaultSchedule schedule = schedule(2, "cut drone 2", "loss for 3s");

    assertThat(schedule.acting(1)).containsExactly(Fault.of("loss for 3s"));
    assertThat(schedule.acting(2))
        .containsExactly(Fault.of("cut drone 2"), Fault.of("loss for 3s"));
    assertThat(take())
        .containsExactly("2 + cut drone 2", "1 + loss 20% for 3s", "2 + loss 20% for 3s");

    schedule.advance(at(2.995));
    assertThat(take()).isEmpty();
    schedule.advance(at(3));
    assertThat(take()).containsExactly("1 - loss 20% for 3s", "2 - loss 20% for 3s");
    assertThat(schedule.acting(1)).isEmpty();
  }

  @Test
  void theClockStartsWithTheFirstTakeoff() {
    FaultSchedule schedule = schedule(1, "cut at 5s for 1s");
    schedule.advance(at(100));
    assertThat(take()).isEmpty();

    schedule.tookOff(at(100));
    schedule.tookOff(at(104));
    schedule.advance(at(104.995));
    assertThat(take()).isEmpty();
    schedule.advance(at(105));
    assertThat(take()).containsExactly("1 + cut at 5s for 1s");
    schedule.advance(at(106));
    schedule.advance(at(200));
    assertThat(take()).containsExactly("1 - cut at 5s for 1s");
  }

  @Test
  void aCommandBeginsItForTheDroneThatTakesIt() {
    FaultSchedule schedule = schedule(2, "cut after forward");
    schedule.commanded(1, "for", at(1));
    schedule.commanded(2, "forward 100", at(2));

    assertThat(take()).containsExactly("2 + cut after \"forward\"");
    assertThat(schedule.acting(1)).isEmpty();
  }

  @Test
  void theNthCommandIsCountedForEachDroneAndBeginsItOnce() {
    FaultSchedule schedule = schedule(1, "cut after 2nd up for 1s");
    schedule.commanded(1, "up 20", at(1));
    assertThat(take()).isEmpty();
    schedule.commanded(1, "up 30", at(2));
    assertThat(take()).hasSize(1);
    schedule.advance(at(3));
    assertThat(take()).hasSize(1);
    schedule.commanded(1, "up 20", at(4));
    schedule.commanded(1, "up 20", at(5));
    assertThat(take()).isEmpty();
  }

  @Test
  void whatIsInjectedLateBeginsAtOnceIfItsTimeIsOver() {
    FaultSchedule schedule = schedule(1);
    schedule.tookOff(at(1));
    schedule.inject(Fault.of("cut at 5s"), at(2));
    assertThat(take()).isEmpty();
    schedule.inject(Fault.of("loss at 5s"), at(9));

    assertThat(take()).containsExactly("1 + cut at 5s", "1 + loss 20% at 5s");
  }

  @Test
  void clearingEndsThemAll() {
    FaultSchedule schedule = schedule(1, "cut", "loss at 5s");
    take();

    schedule.clear();

    assertThat(take()).containsExactly("1 - cut");
    schedule.tookOff(at(1));
    schedule.advance(at(9));
    assertThat(take()).isEmpty();
  }

  @Test
  void aRestartLetsThePlanHappenAgain() {
    FaultSchedule schedule = schedule(1, "cut", "loss at 1s", "corrupt after up for 1s");
    schedule.inject(Fault.of("delay for 60min"), at(0));
    schedule.tookOff(at(0));
    schedule.commanded(1, "up 20", at(0));
    schedule.advance(at(1));
    take();

    schedule.restart(at(2));

    assertThat(take()).containsExactly("1 - loss 20% at 1s");
    schedule.tookOff(at(10));
    schedule.commanded(1, "up 20", at(10));
    schedule.advance(at(11));
    assertThat(take())
        .containsExactly(
            "1 + corrupt 20% after \"up\" for 1s",
            "1 + loss 20% at 1s", "1 - corrupt 20% after \"up\" for 1s");
  }

  private FaultSchedule schedule(int drones, String... texts) {
    FaultSchedule schedule =
        new FaultSchedule(
            new FaultPlan(Optional.empty(), Stream.of(texts).map(Fault::of).toList()),
            drones,
            new FaultSchedule.Observer() {
              @Override
              public void began(int drone, Fault fault) {
                told.add(drone + " + " + fault);
              }

              @Override
              public void ended(int drone, Fault fault) {
                told.add(drone + " - " + fault);
              }
            });
    schedule.advance(SimTime.ZERO);
    return schedule;
  }

  private List<String> take() {
    List<String> taken = List.copyOf(told);
    told.clear();
    return taken;
  }

  private static SimTime at(double seconds) {
    return SimTime.ZERO.plus(seconds);
  }
}
