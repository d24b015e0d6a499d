package tellosimulator.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A closed simulator leaves no threads or descriptors. */
class KitLeaksTest {

  private static final int SIMULATORS = 50;
  private static final int PATIENCE_MS = 20_000;

  /** Descriptors that the JVM itself may open in the meantime, such as those of jars. */
  private static final int OTHERS = 10;

  @Test
  @EnabledOnOs(OS.LINUX)
  void noThreadNoSocketAndNoFileIsLeft() throws Exception {
    fly();
    Set<Thread> threads = threads();
    long files = descriptors();

    for (int i = 0; i < SIMULATORS; i++) {
      fly();
    }

    for (Thread thread : threads()) {
      if (!threads.contains(thread)) {
        thread.join(PATIENCE_MS); // it is about to end
        assertThat(thread.isAlive()).as(thread.getName()).isFalse();
      }
    }
    assertThat(descriptors()).isLessThan(files + OTHERS);
  }

  private static void fly() throws IOException {
    try (TelloSimulator simulator = TelloSimulator.builder().drones(3).start()) {
      ScriptedOperator.fly(simulator.drone(2), "command", "streamon", "takeoff", "land");
    }
  }

  private static Set<Thread> threads() {
    return Thread.getAllStackTraces().keySet();
  }

  private static long descriptors() throws IOException {
    try (Stream<Path> open = Files.list(Path.of("/proc/self/fd"))) {
      return open.count();
    }
  }
}
