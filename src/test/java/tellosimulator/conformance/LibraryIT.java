package tellosimulator.conformance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What a project inherits that has the simulator as a dependency; src/it/consumer is one. */
class LibraryIT {

  private static final Path LIST = Path.of("target", "it", "consumer", "dependencies.txt");

  @Test
  void nobodyInheritsAWindowOrALogger() throws IOException {
    List<String> inherited =
        Files.readString(LIST)
            .lines()
            .map(String::strip)
            .filter(line -> line.matches("[\\w.-]+:[\\w.-]+:jar:.*"))
            .filter(
                line -> !line.matches("org[.](junit|opentest4j|apiguardian|jspecify).*")) // its own
            .map(line -> line.replaceFirst(":jar:.*", ""))
            .sorted()
            .toList();

    assertThat(inherited)
        .containsExactly(
            "io.github.tellosimulator:tello-simulator",
            "org.jcodec:jcodec",
            "org.slf4j:slf4j-api",
            "org.snakeyaml:snakeyaml-engine");
  }
}
