package tellosimulator.conformance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Checks the dependencies of a project that uses the simulator as a library, as src/it/consumer
 * does.
 */
@Tag("slow")
class LibraryIT {

  private static final Path LIST = Path.of("target", "it", "consumer", "dependencies.txt");

  private static final Pattern ARTIFACT =
      Pattern.compile("\\s*([\\w.-]+:[\\w.-]+):jar:.*?:(/.*[.]jar|[A-Z]:.*[.]jar).*");

  /** The test project's own dependencies. */
  private static final Pattern ITS_OWN =
      Pattern.compile("org[.](junit|opentest4j|apiguardian|jspecify).*");

  /** Limit for the total size of all inherited files [bytes]. */
  private static final long MOST = 5_000_000;

  @Test
  void nobodyInheritsAWindowOrALogger() throws IOException {
    assertThat(inherited())
        .containsOnlyKeys(
            "io.github.tellosimulator:tello-simulator",
            "org.jcodec:jcodec",
            "org.slf4j:slf4j-api",
            "org.snakeyaml:snakeyaml-engine");
  }

  @Test
  void theLibraryIsTheKitWithoutTheWindow() throws IOException {
    Path library = inherited().get("io.github.tellosimulator:tello-simulator");
    try (JarFile jar = new JarFile(library.toFile())) {
      assertThat(jar.stream().map(JarEntry::getName))
          .contains("tellosimulator/junit/TelloTest.class")
          .noneMatch(name -> name.startsWith("tellosimulator/view/"));
    }
  }

  @Test
  void itIsSmall() throws IOException {
    long bytes = 0;
    for (Path jar : inherited().values()) {
      bytes += Files.size(jar);
    }
    System.out.printf("The library and what it brings: %,d bytes%n", bytes);

    assertThat(bytes).isLessThan(MOST);
  }

  /** Returns the files that a project inherits, by group and name. */
  private static Map<String, Path> inherited() throws IOException {
    Map<String, Path> files = new TreeMap<>();
    for (String line : Files.readAllLines(LIST)) {
      Matcher artifact = ARTIFACT.matcher(line);
      if (artifact.matches() && !ITS_OWN.matcher(artifact.group(1)).matches()) {
        files.put(artifact.group(1), Path.of(artifact.group(2)));
      }
    }
    return files;
  }
}
