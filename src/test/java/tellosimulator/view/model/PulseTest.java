package tellosimulator.view.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.testing.CapturedLog;

class PulseTest {

  private final List<String> done = new ArrayList<>();
  private final Pulse pulse = new Pulse(() -> done.add("mirror"), () -> false);

  @Test
  void theMirrorComesFirstThenTheListenersInTheirOrder() {
    pulse.onBeat(nanos -> done.add("first at " + nanos));
    pulse.onBeat(nanos -> done.add("second"));

    pulse.beat(7);

    assertThat(done).containsExactly("mirror", "first at 7", "second");
  }

  @Test
  void oneThatFailsDoesNotHoldUpTheOthersAndIsToldOnce() throws InterruptedException {
    pulse.onBeat(
        nanos -> {
          throw new IllegalStateException("broken on purpose");
        });
    pulse.onBeat(nanos -> done.add("second"));

    try (CapturedLog log = CapturedLog.of(Pulse.class)) {
      pulse.beat(1);
      pulse.beat(2);

      assertThat(log.next()).startsWith("A part of the window failed; please report this: ");
      assertThat(log.isEmpty()).isTrue();
    }
    assertThat(done).containsExactly("mirror", "second", "mirror", "second");
  }
}
