package tellosimulator.release;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.testing.Jvm;

/**
 * The programs for several systems, which the profile {@code all-systems} builds; skipped without
 * it.
 */
@Tag("process")
class AllSystemsIT {

  private static final int PATIENCE_SECONDS = 240;

  /** Machine codes in the headers of ELF, Mach-O and PE files. */
  private static final Map<Integer, String> PROCESSORS =
      Map.of(
          0x3e, "x64", // EM_X86_64
          0xb7, "aarch64", // EM_AARCH64
          0x01000007, "x64", // CPU_TYPE_X86_64
          0x0100000c, "aarch64", // CPU_TYPE_ARM64
          0x8664, "x64"); // IMAGE_FILE_MACHINE_AMD64

  @TempDir private Path home;

  @ParameterizedTest
  @CsvSource({"x64, linux mac win", "aarch64, linux-aarch64 mac-aarch64"})
  void allLibrariesOfItsSystemsAreInside(String processor, String classifiers) throws IOException {
    Map<String, String> processors = processorsOfLibraries(program(processor));

    assertThat(processors.values()).containsOnly(processor);
    Set<String> expected = new TreeSet<>();
    for (String classifier : classifiers.split(" ", -1)) {
      expected.addAll(processorsOfLibraries(graphics(classifier)).keySet());
    }
    assertThat(expected).contains("libglass.so", "libglass.dylib").hasSizeGreaterThan(15);
    assertThat(processors.keySet()).containsExactlyInAnyOrderElementsOf(expected);
  }

  @ParameterizedTest
  @CsvSource({"x64", "aarch64"})
  @Timeout(PATIENCE_SECONDS)
  void itStartsWithoutAWindowOnAnyProcessor(String processor) throws Exception {
    assertReady(program(processor), "--headless");
  }

  @Test
  @Timeout(PATIENCE_SECONDS)
  @EnabledOnOs(value = OS.LINUX, architectures = "amd64")
  @EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
  void itsWindowOpensHere() throws Exception {
    assertReady(program("x64"), "--on");
  }

  /** Starts a program, waits until its drone accepts commands, and ends it. */
  private void assertReady(Path program, String option) throws IOException, InterruptedException {
    Path errors = home.resolve("errors");
    ProcessBuilder builder =
        Jvm.process(
                List.of(
                    Jvm.java(),
                    "-Duser.home=" + home,
                    "-jar",
                    program.toString(),
                    option,
                    "--command-port",
                    "0",
                    "--log-level",
                    "warn"))
            .redirectError(errors.toFile());

    List.of("XDG_CONFIG_HOME", "XDG_DATA_HOME", "APPDATA", "LOCALAPPDATA")
        .forEach(variable -> builder.environment().put(variable, home.toString()));
    Process process = builder.start();
    try (BufferedReader printed = process.inputReader(StandardCharsets.UTF_8)) {
      assertThat(printed.readLine()).as(Files.readString(errors)).startsWith("ready");
      assertThat(errors).isEmptyFile();
    } finally {
      process.destroy();
      process.waitFor();
    }
  }

  private static Path program(String processor) {
    Path program = Path.of("target", "tello-simulator-all-" + processor + ".jar");
    assumeTrue(Files.exists(program), program + " is not built");
    return program;
  }

  /** Returns JavaFX's jar for a system, next to this system's one in the local repository. */
  private static Path graphics(String classifier) {
    for (String jar : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      String name = Path.of(jar).getFileName().toString();
      if (name.matches("javafx-graphics-[\\d.]+-[\\w-]+\\.jar")) {
        return Path.of(jar)
            .resolveSibling(name.replaceFirst("(graphics-[\\d.]+-).*", "$1" + classifier + ".jar"));
      }
    }
    throw new AssertionError("JavaFX is not on the class path");
  }

  /** Returns the processor of each native library in a jar. */
  private static Map<String, String> processorsOfLibraries(Path jar) throws IOException {
    Map<String, String> processors = new TreeMap<>();
    try (ZipFile zip = new ZipFile(jar.toFile())) {
      for (ZipEntry entry : (Iterable<ZipEntry>) zip.stream().map(e -> (ZipEntry) e)::iterator) {
        if (entry.getName().matches(".*\\.(so|dylib|dll)")) {
          try (InputStream in = zip.getInputStream(entry)) {
            processors.put(entry.getName(), processor(in.readNBytes(4096)));
          }
        }
      }
    }
    return processors;
  }

  private static String processor(byte[] start) {
    ByteBuffer header = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN);
    int machine =
        switch (header.getInt(0)) {
          case 0x464c457f -> header.getShort(0x12); // ELF: e_machine
          case 0xfeedfacf -> header.getInt(4); // Mach-O of 64 bits: cputype
          default -> header.getShort(header.getInt(0x3c) + 4) & 0xffff; // PE: after "PE\0\0"
        };
    return PROCESSORS.getOrDefault(machine, "machine " + machine);
  }
}
