package tellosimulator.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.PrimitiveIterator;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

class PeriodicTest {

  @Test
  void happensAtItsStartAndThenEveryPeriod() {
    Periodic periodic = new Periodic(SimTime.ZERO.plus(0.020), () -> 0.100);

    assertThat(dueMillis(periodic, 0.300)).containsExactly(20L, 120L, 220L);
  }

  @Test
  void theMeanPeriodDoesNotDependOnTheStep() {
    // 100.6 ms is not a multiple of 5 ms: 1000 periods are 100.6 s, late by less than one step.
    Periodic periodic = new Periodic(SimTime.ZERO, () -> 0.1006);

    List<Long> due = dueMillis(periodic, 101);

    assertThat(due.get(1000)).isBetween(100_600L, 100_605L);
  }

  @Test
  void eachPeriodMayDiffer() {
    PrimitiveIterator.OfDouble periods = DoubleStream.of(0.045, 0.150, 0.100, 1).iterator();
    Periodic periodic = new Periodic(SimTime.ZERO, periods::nextDouble);

    assertThat(dueMillis(periodic, 0.500)).containsExactly(0L, 45L, 195L, 295L);
  }

  private static List<Long> dueMillis(Periodic periodic, double seconds) {
    List<Long> due = new ArrayList<>();
    for (SimTime now = SimTime.ZERO; now.seconds() <= seconds; now = now.next()) {
      if (periodic.due(now)) {
        due.add(now.nanos() / 1_000_000);
      }
    }
    return due;
  }
}
