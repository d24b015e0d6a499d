import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;

/**
 * Makes what is handed out to people without a JDK: a folder with the program and a Java runtime of
 * its own, packed for copying, and installers of the operating system on which this runs. The
 * runtime is that of the JDK on which this runs. {@code mvn -Papp-image package} starts it:
 *
 * <pre>java packaging/AppImage.java JAR VERSION FOLDER true|false</pre>
 */
public final class AppImage {

  private static final String NAME = "tello-simulator";
  private static final String TITLE = "Tello Simulator";
  private static final String MAIN_CLASS = "tellosimulator.Main";

  /** What {@code jdeps} cannot see: the service that writes numbers and dates in German. */
  private static final String GERMAN = "jdk.localedata";

  /**
   * The class-data archive holds for a jar of this time alone, which packers must keep, and
   * linux/postinst restores. Documented: zip files count in steps of two seconds.
   */
  private static final FileTime JAR_TIME = FileTime.fromMillis(1_735_689_600_000L);

  /** How long the program may take for a reply of its training flight [ms]. */
  private static final int PATIENCE_MS = 120_000;

  /** First Java with an ahead-of-time cache in one step. Documented: JEP 514. */
  private static final int AOT_CACHE = 25;

  /** First Java that warns of native access and of Unsafe. Documented: JEP 472 and JEP 498. */
  private static final int WARNINGS = 24;

  private static final int JAVA = Runtime.version().feature();

  private static final String ARCHIVE = NAME + (JAVA >= AOT_CACHE ? ".aot" : ".jsa");

  private static final String WINDOW_ARCHIVE = ARCHIVE.replace(NAME, NAME + "-window");

  private static final String ARCHIVE_OPTION =
      JAVA >= AOT_CACHE ? "-XX:AOTCache" : "-XX:SharedArchiveFile";

  private enum Platform {
    LINUX("src/main/resources/tellosimulator/view/app/icon.png", "deb", "tar.gz"),
    MACOS("packaging/icon.icns", "dmg", "tar.gz"),
    WINDOWS("packaging/icon.ico", "msi", "zip");

    private final String icon;
    private final String installer;
    private final String archive;

    Platform(String icon, String installer, String archive) {
      this.icon = icon;
      this.installer = installer;
      this.archive = archive;
    }

    static Platform here() {
      String name = System.getProperty("os.name").toLowerCase(Locale.ROOT);
      return name.startsWith("windows") ? WINDOWS : name.startsWith("mac") ? MACOS : LINUX;
    }

    /** Where jpackage puts the program's jar. */
    Path programFolder(Path image) {
      return switch (this) {
        case LINUX -> image.resolve("lib").resolve("app");
        case MACOS -> image.resolve("Contents").resolve("app");
        case WINDOWS -> image.resolve("app");
      };
    }

    /** Where jpackage puts the Java runtime. */
    Path runtime(Path image) {
      return switch (this) {
        case LINUX -> image.resolve("lib").resolve("runtime");
        case MACOS -> image.resolve("Contents").resolve("runtime").resolve("Contents/Home");
        case WINDOWS -> image.resolve("runtime");
      };
    }

    Path image(Path folder) {
      return folder.resolve(this == MACOS ? TITLE + ".app" : NAME);
    }
  }

  private final Platform platform = Platform.here();
  private final Path sources = Path.of("packaging").toAbsolutePath();
  private final Path jar;
  private final String version;
  private final Path folder;
  private final Path image;
  private final boolean installer;

  private AppImage(Path jar, String version, Path folder, boolean installer) {
    this.installer = installer;
    this.jar = jar.toAbsolutePath();
    this.version = version.replaceFirst("-.*", ""); // installers take numbers alone
    this.folder = folder.toAbsolutePath();
    image = platform.image(this.folder);
  }

  /**
   * Takes the program's jar, its version, the folder that is written, which is emptied, and whether
   * an installer is made, too.
   */
  public static void main(String[] args) throws IOException, InterruptedException {
    new AppImage(Path.of(args[0]), args[1], Path.of(args[2]), Boolean.parseBoolean(args[3])).make();
  }

  private void make() throws IOException, InterruptedException {
    delete(folder);
    Path input = Files.createDirectories(folder.resolve("input"));
    Path program = input.resolve(NAME + ".jar");
    Files.copy(jar, program);
    Path runtime = folder.resolve("runtime");
    say("linking a runtime with the modules that the program needs");
    makeRuntime(program, runtime);
    say("making the image");
    makeImage(input, runtime);
    Files.setLastModifiedTime(platform.programFolder(image).resolve(NAME + ".jar"), JAR_TIME);
    say("flying, to archive the classes that a flight loads");
    archiveClasses();
    if (platform == Platform.MACOS) { // the seal was made before the archive
      run(List.of("codesign", "--force", "--deep", "--sign", "-", image.toString()));
    }
    delete(input);
    delete(runtime);
    say("packing the image");
    pack();
    if (installer) {
      say("making the ." + platform.installer);
      makeInstaller();
    }
    say("made: " + image);
  }

  private static void say(String step) {
    System.out.println(step);
  }

  private void makeRuntime(Path program, Path runtime) {
    TreeSet<String> modules = new TreeSet<>(List.of(GERMAN));
    String named =
        tool(
            "jdeps",
            "--print-module-deps",
            "--ignore-missing-deps",
            "--multi-release",
            Integer.toString(JAVA),
            program.toString());
    modules.addAll(Arrays.asList(named.trim().split(",", -1)));
    tool(
        "jlink",
        "--add-modules",
        String.join(",", modules),
        "--include-locales=en,de",
        "--strip-debug",
        "--no-man-pages",
        "--no-header-files",
        "--output",
        runtime.toString());
  }

  private void makeImage(Path input, Path runtime) throws IOException {
    List<String> words =
        new ArrayList<>(
            List.of(
                "--type",
                "app-image",
                "--name",
                image.getFileName().toString().replace(".app", ""),
                "--input",
                input.toString(),
                "--main-jar",
                NAME + ".jar",
                "--main-class",
                MAIN_CLASS,
                "--runtime-image",
                runtime.toString(),
                "--dest",
                folder.toString()));
    words.addAll(description());
    List<String> options = javaOptions();
    // Where the archive does not hold, the program starts as a jar does; nobody needs to be told.
    options.add(JAVA >= AOT_CACHE ? "-Xlog:aot*=off" : "-Xlog:cds=off");
    for (String option : options) {
      words.add("--java-options");
      words.add(option);
    }
    words.add("--java-options");
    words.add(ARCHIVE_OPTION + "=$APPDIR/" + ARCHIVE); // documented: jpackage
    if (platform == Platform.MACOS) {
      words.addAll(List.of("--mac-package-identifier", "io.github.tellosimulator"));
    }
    if (platform == Platform.WINDOWS) { // a program with a window has no console there
      words.addAll(
          List.of(
              "--add-launcher",
              NAME + "-console=" + sources.resolve("windows").resolve("console.properties")));
    }
    tool("jpackage", words.toArray(String[]::new));
    if (platform == Platform.LINUX) {
      Path launcher = image.resolve("bin").resolve(NAME);
      String script = Files.readString(sources.resolve("linux").resolve("launcher.sh"));
      Files.writeString(
          launcher,
          script
              .replace("OPTIONS", String.join(" ", options).replace("*", "\\*"))
              .replace("HOLDS", ARCHIVE_OPTION)
              .replace("ARCHIVE", ARCHIVE)
              .replace("WINDOW", WINDOW_ARCHIVE));
      Files.delete(image.resolve("lib").resolve("libapplauncher.so"));
    }
  }

  private List<String> description() {
    return List.of(
        "--app-version",
        version,
        "--vendor",
        TITLE,
        "--description",
        "Simulates Tello drones for programs that fly them",
        "--copyright",
        "Apache-2.0",
        "--icon",
        Path.of(platform.icon).toAbsolutePath().toString());
  }

  /**
   * What a jar cannot say: a collector that needs little memory and gives it back. Of the heap
   * there is no upper bound, as large posters would not fit. Measured: see docs/benchmarks.md. The
   * archive is made with the same options, or it would not be used.
   */
  private List<String> javaOptions() {
    List<String> options =
        new ArrayList<>(
            List.of(
                "-XX:+UseSerialGC",
                "-Xms24m",
                "-Xmn16m",
                "-XX:MinHeapFreeRatio=10",
                "-XX:MaxHeapFreeRatio=25"));
    if (platform == Platform.LINUX) {
      options.add("-XX:TrimNativeHeapInterval=5000"); // of glibc's arenas
    }
    if (JAVA >= WARNINGS) {
      options.add("--enable-native-access=ALL-UNNAMED");
      options.add("--sun-misc-unsafe-memory-access=allow");
    }
    return options;
  }

  /** Keeps the classes as training flights have loaded them. */
  private void archiveClasses() throws IOException, InterruptedException {
    archiveClasses(ARCHIVE, false);
    if (platform == Platform.LINUX && System.getenv("DISPLAY") != null) {
      archiveClasses(WINDOW_ARCHIVE, true);
    }
  }

  private void archiveClasses(String name, boolean window)
      throws IOException, InterruptedException {
    Path archive = platform.programFolder(image).resolve(name);
    if (JAVA >= AOT_CACHE) {
      List<String> options = javaOptions();
      options.add("-XX:AOTCacheOutput=" + archive);
      fly(options, window);
    } else {
      Path classes = folder.resolve("classes.txt");
      fly(List.of("-XX:DumpLoadedClassList=" + classes), window);
      keepArchivable(classes);
      // G1 alone archives objects, too; the serial collector loads them.
      run(
          java(
              List.of(
                  "-XX:+UseG1GC",
                  "-Xshare:dump",
                  "-XX:SharedClassListFile=" + classes,
                  "-XX:SharedArchiveFile=" + archive)));
      Files.delete(classes);
    }
    if (!Files.exists(archive)) {
      throw new IOException("No class-data archive was written to " + archive + ".");
    }
  }

  /** Java 17 fails on a lambda that implements an interface of a class file as old as picocli's. */
  private static void keepArchivable(Path classes) throws IOException {
    List<String> kept =
        Files.readAllLines(classes).stream()
            .filter(line -> !line.startsWith("@lambda-proxy tellosimulator/cli/"))
            .toList();
    Files.write(classes, kept);
  }

  private List<String> java(List<String> options) {
    List<String> command = new ArrayList<>();
    command.add(platform.runtime(image).resolve("bin").resolve("java").toString());
    command.addAll(options);
    command.add("-cp");
    command.add(platform.programFolder(image).resolve(NAME + ".jar").toString());
    return command;
  }

  /** A flight with film. */
  private void fly(List<String> options, boolean window) throws IOException, InterruptedException {
    int port = freePort();
    List<String> command = java(options);
    command.add(MAIN_CLASS);
    command.addAll(List.of(window ? "--on" : "--headless", "--command-port", "" + port));
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT);
    Path settings = folder.resolve("settings"); // those of the person who builds stay as they are
    builder.environment().put("XDG_CONFIG_HOME", settings.toString());
    builder.environment().put("XDG_DATA_HOME", settings.toString());
    Process program = builder.start();
    try (var lines = program.inputReader(UTF_8)) {
      String line = lines.readLine();
      while (line != null && !line.startsWith("ready")) {
        line = lines.readLine();
      }
      if (line == null) {
        throw new IOException("The program was not ready for its training flight.");
      }
      for (String each : List.of("command", "streamon", "takeoff", "cw 90", "battery?", "land")) {
        send(each, port);
      }
      if (window) {
        program.toHandle().destroy(); // the process itself would close its streams
      } else {
        program.outputWriter(UTF_8).append("quit\n").close();
      }
      while (lines.readLine() != null) {
        // what it still has to say
      }
      program.waitFor();
    } finally {
      program.destroyForcibly();
    }
    delete(settings);
  }

  private static void send(String command, int port) throws IOException {
    try (DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      socket.setSoTimeout(PATIENCE_MS);
      byte[] bytes = command.getBytes(UTF_8);
      socket.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port));
      socket.receive(new DatagramPacket(new byte[1000], 1000));
    }
  }

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  /** The folder in one file; the program {@code tar} of all three systems makes both kinds. */
  private void pack() throws IOException, InterruptedException {
    Path file = folder.resolve(packageName() + "." + platform.archive);
    run(
        List.of(
            "tar",
            "-C",
            folder.toString(),
            "-a",
            "-cf",
            file.toString(),
            "" + image.getFileName()));
  }

  private String packageName() {
    String processor =
        System.getProperty("os.arch").replace("amd64", "x64").replace("x86_64", "x64");
    return String.join("-", NAME, version, platform.name().toLowerCase(Locale.ROOT), processor);
  }

  private void makeInstaller() throws IOException, InterruptedException {
    List<String> words =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "jpackage").toString(),
                "--type",
                platform.installer,
                "--name",
                platform == Platform.LINUX ? NAME : TITLE,
                "--app-image",
                image.toString(),
                "--dest",
                folder.toString()));
    words.addAll(description());
    words.addAll(
        switch (platform) {
          case LINUX ->
              List.of(
                  "--linux-package-name",
                  NAME,
                  "--linux-shortcut",
                  "--file-associations",
                  sources.resolve("scenario.properties").toString(),
                  "--resource-dir",
                  sources.resolve("linux").toString());
          case WINDOWS ->
              List.of(
                  "--win-menu",
                  "--win-shortcut-prompt",
                  "--win-per-user-install",
                  "--win-upgrade-uuid",
                  "5d6f3c5e-6d3b-4f1e-9a5c-2f3d8d5f7a41");
          case MACOS -> List.of();
        });
    run(words);
  }

  private static String tool(String name, String... words) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream out = new PrintStream(said, true, UTF_8);
    int code = ToolProvider.findFirst(name).orElseThrow().run(out, out, words);
    if (code != 0) {
      throw new IllegalStateException(name + " failed:\n" + said.toString(UTF_8));
    }
    return said.toString(UTF_8);
  }

  private static void run(List<String> command) throws IOException, InterruptedException {
    Path said = Files.createTempFile(NAME, ".log");
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(said.toFile());
    // Documented: dpkg-deb(1). The default takes eight minutes for three megabytes less.
    builder.environment().putIfAbsent("DPKG_DEB_COMPRESSOR_LEVEL", "1");
    int code = builder.start().waitFor();
    if (code != 0) {
      throw new IOException(command + " failed:\n" + Files.readString(said));
    }
    Files.delete(said);
  }

  private static void delete(Path tree) throws IOException {
    if (!Files.exists(tree)) {
      return;
    }
    try (Stream<Path> files = Files.walk(tree)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
  }
}
