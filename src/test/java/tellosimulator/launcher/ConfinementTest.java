package tellosimulator.launcher;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.AnnotatedElementContext;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.io.TempDirFactory;
import tellosimulator.launcher.Confinement.Limits;
import tellosimulator.launcher.ProgramRun.Distrust;
import tellosimulator.launcher.ProgramRun.NetworkChoice;
import tellosimulator.launcher.ProgramRun.Plan;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Uses plain scripts as programs. */
@NeedsTool({Tool.NAMESPACES, Tool.SH, Tool.TAR})
@Timeout(60)
class ConfinementTest {

  /** The folder of a teacher; not below {@code /tmp}, where nothing is visible anyway. */
  @TempDir(factory = InTarget.class)
  private Path course;

  @TempDir private Path scratch;

  static final class InTarget implements TempDirFactory {
    @Override
    public Path createTempDirectory(AnnotatedElementContext element, ExtensionContext context)
        throws IOException {
      Path target = Path.of("target").toAbsolutePath();
      return Files.createTempDirectory(Files.createDirectories(target), "confinement");
    }
  }

  @BeforeEach
  void fillTheFolder() throws IOException {
    Files.setPosixFilePermissions(course, PosixFilePermissions.fromString("rwxr-xr-x"));
    file("hand-ins/secret", "SECRET");
    file("secret", "SECRET");
    program("bin/tool");
    program(".venv/bin/tool");
    file(".venv/lib/packages", "PACKAGES");
  }

  private void file(String name, String text) throws IOException {
    Path file = course.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  /** Writes a program that prints files of its neighborhood. */
  private void program(String name) throws IOException {
    file(name, "#!/bin/sh\ncd \"${0%/bin/*}\"\ncat lib/* secret hand-ins/* ../secret\necho RAN\n");
    Files.setPosixFilePermissions(
        course.resolve(name), PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  private Confinement confinement(List<Path> hidden) throws IOException {
    return new Confinement(
        Files.createTempDirectory(scratch, "files"),
        Files.createTempDirectory(scratch, "stash"),
        hidden,
        new Limits(30, 10_000, 100, 10, 10));
  }

  /** Returns what a command prints. */
  private String confined(List<Path> hidden, String... command) throws Exception {
    Path output = scratch.resolve("output.txt");
    Plan plan =
        new Plan(
            List.of("sh", "-c", "echo ready; read typed", "simulator"),
            List.of(command),
            1,
            NetworkChoice.PRIVATE,
            false,
            Optional.of(output),
            Optional.of(new Distrust(confinement(hidden), scratch.resolve("log.txt"))));
    new ProgramRun(plan, new PrintStream(OutputStream.nullOutputStream(), false, UTF_8)).run();
    return Files.readString(output);
  }

  @Test
  void theFoldersThatBecomeTheDiskMayBeHidden() throws Exception {
    List<Path> hidden = List.of(Path.of("/tmp"), Path.of("/var/tmp"), Path.of("/"));

    assertThat(confined(hidden, "sh", "-c", "pwd; echo a > /tmp/a; cat /tmp/a"))
        .isEqualTo("/tmp/flight\na\n");
  }

  @Test
  void hiddenFoldersAreEmpty() throws Exception {
    String look = "ls -A " + course + " && cat " + course + "/secret";

    assertThat(confined(List.of(course), "sh", "-c", look)).doesNotContain("bin\n", "SECRET");
  }

  /** The link disappears with its parent, but the folder would remain visible under its name. */
  @Test
  void aHiddenLinkHidesItsFolder() throws Exception {
    Path link = Files.createSymbolicLink(course.resolve(".venv/link"), course.resolve("hand-ins"));
    List<Path> hidden = List.of(link.getParent(), link);
    String look = "cat " + course + "/hand-ins/secret";

    assertThat(confined(hidden, "sh", "-c", look)).doesNotContain("SECRET");
  }

  @Test
  void aProgramInAHiddenFolderRunsAndSeesNoMoreThanItsFolder() throws Exception {
    List<Path> hidden = List.of(course, course.resolve("hand-ins"));

    assertThat(confined(hidden, course + "/bin/tool")).contains("RAN").doesNotContain("SECRET");
  }

  @Test
  void aVirtualEnvironmentInAHiddenFolderKeepsItsPackages() throws Exception {
    List<Path> hidden = List.of(course, course.resolve("hand-ins"));

    assertThat(confined(hidden, course + "/.venv/bin/tool"))
        .contains("PACKAGES", "RAN")
        .doesNotContain("SECRET");
  }

  @Test
  void onlyHarmlessDevicesExist() throws Exception {
    assertThat(
            confined(
                List.of(),
                "sh",
                "-c",
                "echo $(ls /dev); echo x > /dev/null; head -c 3 /dev/urandom | wc -c;"
                    + " echo shared > /dev/shm/a; cat /tmp/a; echo x > /dev/evil && echo WROTE"))
        .startsWith("fd full null random shm stderr stdin stdout urandom zero\n3\nshared\n")
        .doesNotContain("WROTE");
  }

  @Test
  void aProgramHasItsOwnSharedMemoryAndCannotMakeNamespaces() throws Exception {
    assertThat(confined(List.of(), "sh", "-c", "readlink /proc/self/ns/ipc; unshare -Ur echo MADE"))
        .startsWith("ipc:")
        .doesNotContain("MADE", Files.readSymbolicLink(Path.of("/proc/self/ns/ipc")).toString());
  }

  @Test
  void pythonFindsThePackagesOfTheUser() throws Exception {
    assertThat(confined(List.of(), "sh", "-c", "echo $HOME $PYTHONUSERBASE"))
        .isEqualTo("/tmp " + System.getProperty("user.home") + "/.local\n");
  }

  @Test
  void aBuildKeepsTheFolderOfItsProgram() throws Exception {
    Path output = scratch.resolve("build.txt");

    assertThat(
            new ConfinedBuild(() -> false)
                .run(
                    confinement(List.of(course)),
                    List.of(course + "/.venv/bin/tool"),
                    scratch.resolve("built.tar"),
                    output))
        .contains(0);
    assertThat(output).content().contains("PACKAGES", "RAN").doesNotContain("SECRET");
  }

  @Test
  void aClosedBuildEnds() {
    AtomicInteger looks = new AtomicInteger();

    assertThatThrownBy(
            () ->
                new ConfinedBuild(() -> looks.incrementAndGet() > 2)
                    .run(
                        confinement(List.of()),
                        List.of("sleep", "1000"),
                        scratch.resolve("built.tar"),
                        scratch.resolve("build.txt")))
        .isInstanceOf(InterruptedException.class);
  }
}
