package tellosimulator.view.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.testing.CapturedLog;

class UiTickerTest {

  private final List<String> done = new ArrayList<>();
  private final UiTicker ticker = new UiTicker(() -> done.add("mirror"), () -> false);

  @Test
  void theMirrorComesFirstThenTheListenersInTheirOrder() {
    ticker.onTick(nanos -> done.add("first at " + nanos));
    ticker.onTick(nanos -> done.add("second"));

    ticker.tick(7);

    assertThat(done).containsExactly("mirror", "first at 7", "second");
  }

  @Test
  void oneThatFailsDoesNotHoldUpTheOthersAndIsToldOnce() throws InterruptedException {
    ticker.onTick(
        nanos -> {
          throw new IllegalStateException("broken on purpose");
        });
    ticker.onTick(nanos -> done.add("second"));

    try (CapturedLog log = CapturedLog.of(UiTicker.class)) {
      ticker.tick(1);
      ticker.tick(2);

      assertThat(log.next()).startsWith("A part of the window failed; please report this: ");
      assertThat(log.isEmpty()).isTrue();
    }
    assertThat(done).containsExactly("mirror", "second", "mirror", "second");
  }
}
