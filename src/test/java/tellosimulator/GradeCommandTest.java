package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.grade.GradedFlight;
import tellosimulator.grade.GradedHandIn;
import tellosimulator.grade.Grades;
import tellosimulator.recording.FlightResult;
import tellosimulator.scenario.Assignment.Scale;
import tellosimulator.scenario.Assignment.Take;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Tests the subcommand {@code grade} on the command line. */
class GradeCommandTest {

  /** A unique number of seconds that identifies the processes of this test. */
  private static final String NAP = "7" + System.nanoTime();

  /** The beginning of a program in Python that uses nothing but sockets. */
  private static final String PYTHON =
      """
      import os, signal, socket, time
      s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
      s.bind(("", 9000))
      s.settimeout(20)
      def send(text):
          s.sendto(text.encode(), ("192.168.10.1", 8889))
          print(text, "->", s.recv(1024).decode(errors="replace"))
      """;

  /** Reaches the first of the two goals, and lands. */
  private static final String HALF =
      """
      send("command")
      send("takeoff")
      send("forward 100")
      send("land")
      """;

  private static final String COURSE =
      """
      room: {width: 600, depth: 600, height: 300}
      obstacles:
        - cylinder: {name: pillar, at: [0, 200], radius: 20, height: 250}
      drones:
        - {start: [0, 0]}
      goals:
        - reach: {at: [100, 0, 40], radius: 40, points: 10}
        - land: {at: [200, 0], radius: 40, points: 20}
      in-order: true
      touch: forbidden
      """;

  private static final String ASSIGNMENT =
      """
      name: Two places
      courses: [course.yaml]
      entry: [fly.py, Fly.java]
      limits: {wall: 25, time: 40, memory: 400, processes: 20, disk: 5}
      """;

  @TempDir private Path folder;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private int grade(Object... words) {
    return Main.run(
        Stream.concat(Stream.of("grade"), Stream.of(words).map(String::valueOf))
            .toArray(String[]::new),
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  private Path file(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private Path assignment() throws IOException {
    file("course.yaml", COURSE);
    return file("assignment.yaml", ASSIGNMENT);
  }

  private void handIn(String name, String program) throws IOException {
    file("hand-ins/" + name + "/fly.py", PYTHON + program);
  }

  /** Returns the values of some columns of each row, by hand-in. */
  private Map<String, String> rows(Path results, int... columns) throws IOException {
    Map<String, String> rows = new TreeMap<>();
    List<String> lines = Files.readAllLines(results.resolve("grades.csv"));
    for (String line : lines.subList(1, lines.size())) {
      String[] cells = line.split(",", -1);
      StringBuilder row = new StringBuilder();
      for (int column : columns) {
        row.append(row.length() == 0 ? "" : ", ").append(cells[column]);
      }
      rows.put(cells[0], row.toString());
    }
    return rows;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          a.yaml                  | Grade needs an assignment and hand-ins, such as: grade assignment.yaml hand-ins. Try --help.
          --shard 5/4 a.yaml b    | Invalid value for option '--shard': a shard is a number from 1, and how many there are, such as 1/4. Try --help.
          --merge a b             | --merge needs -o DIR. Try --help.
          --regrade a b           | --regrade needs one folder of results. Try --help.
          --merge a -o b --jobs 2 | --jobs does not go with --merge. Try --help.
          --regrade a --only Ann  | --only does not go with --regrade. Try --help.
          """)
  void mistakesAreOneSentence(String line, String sentence) {
    assertThat(grade((Object[]) line.split(" "))).isEqualTo(2);

    assertThat(err.toString(StandardCharsets.UTF_8)).endsWith(sentence + "\n");
    assertThat(out.size()).isZero();
  }

  @Test
  void checkingSaysEverythingThatIsWrong() throws IOException {
    file("course.yaml", "goals:\n  - land: {at: [0, 0], radius: none}\n");
    Path wrong = file("wrong.yaml", "courses: [course.yaml, absent.yaml]\nattempts: 0\n");
    Path right = file("right.yaml", "name: A\ncourses: [course.yaml]\n");

    assertThat(grade("--check", wrong)).isEqualTo(2);
    assertThat(err.toString(StandardCharsets.UTF_8).lines())
        .containsExactly(
            wrong + ":1:1: an assignment needs the key name",
            wrong + ":1:24: there is neither a file nor a scenario \"absent.yaml\"",
            wrong + ":2:11: expected a number from 1 to 20, found \"0\"");
    err.reset();
    assertThat(grade("--check", right)).isEqualTo(2);
    assertThat(err.toString(StandardCharsets.UTF_8))
        .startsWith(folder.resolve("course.yaml") + ":2:32: expected a length in cm");
  }

  @Test
  void checkingFindsTheFilesToStart() throws IOException {
    Path assignment = assignment();
    handIn("Ann", HALF);
    file("hand-ins/Bob/final.py", HALF);

    assertThat(grade("--check", assignment, folder.resolve("hand-ins"))).isZero();

    assertThat(out.toString(StandardCharsets.UTF_8).lines())
        .containsExactly(
            "Ann: fly.py",
            "Bob: no entry file",
            assignment + ": no mistakes; hand-ins that cannot be flown: 1");
  }

  @Test
  void aFolderWithoutHandInsIsOneSentence() throws IOException {
    Path nothing = Files.createDirectories(folder.resolve("nothing"));

    assertThat(grade(assignment(), nothing, "-o", folder.resolve("results"))).isEqualTo(1);

    assertThat(err.toString(StandardCharsets.UTF_8))
        .isEqualTo(
            "The hand-ins were not graded: "
                + nothing
                + " contains no hand-ins: expected a folder or a program for each student.\n");
  }

  /** Writes results with one flight. */
  private Path results(String program, String recording) throws IOException {
    FlightResult result =
        new FlightResult("missed", Optional.empty(), 1, List.of(), Optional.empty(), 3, 0, 0, 0);
    GradedFlight flight = new GradedFlight("course", 1, 1, result, program, "max", 2.5, recording);
    GradedHandIn handIn =
        new GradedHandIn("Ann", "", "", "Ann", "Ann", "fly.py", 0, 0, 0, 0, false, List.of(flight));
    Path results = Files.createDirectories(folder.resolve("results"));
    new Grades("Two places", Take.BEST, Scale.DEFAULT, List.of(handIn)).write(results);
    return results;
  }

  @Test
  void flightsInWhichTheSimulatorFailedAreNoSuccess() throws IOException {
    Path results = results(GradedFlight.SIMULATOR_FAILED, "");

    assertThat(grade("--merge", results, "-o", folder.resolve("merged"))).isEqualTo(1);

    assertThat(err.toString(StandardCharsets.UTF_8))
        .isEqualTo(
            "The simulator failed in flights of these hand-ins; grade again to fly them again:"
                + " Ann.\n");
    assertThat(folder.resolve("merged/index.html")).exists();
  }

  @Test
  void aRecordingThatCannotBeReadKeepsItsPoints() throws IOException {
    Path results = results("ended", "recordings/Ann/course-1-1/flight");
    byte[] json = Files.readAllBytes(results.resolve("grades.json"));

    assertThat(grade("--regrade", results)).isEqualTo(1);

    assertThat(err.toString(StandardCharsets.UTF_8))
        .startsWith(
            results.resolve("recordings/Ann/course-1-1/flight")
                + " cannot be replayed, so its points stay as they were: ")
        .endsWith("name the folder of a recording.\n")
        .hasLineCount(1);
    assertThat(results.resolve("grades.json")).hasBinaryContent(json);
  }

  /** Flies programs. */
  @Nested
  @Tag("process")
  @Tag("slow")
  @NeedsTool({Tool.NAMESPACES, Tool.PYTHON, Tool.SH, Tool.TAR})
  @Timeout(600)
  class Flying {

    /** The hand-ins of a class, from perfect to wrong. */
    private void nine() throws IOException {
      handIn("perfect", "send('command')\nsend('takeoff')\nsend('forward 200')\nsend('land')\n");
      handIn(
          "slow",
          """
          send('command')
          send('takeoff')
          send('go 200 0 0 10')
          send('go -200 0 0 10')
          send('go 200 0 0 10')
          send('land')
          """);
      handIn("pillar", "send('command')\nsend('takeoff')\nsend('left 300')\nsend('land')\n");
      handIn("stays", "send('command')\nsend('takeoff')\nsend('forward 100')\n");
      handIn("loop", "send('command')\nwhile True: pass\n");
      file("hand-ins/syntax/fly.py", "def fly(:\n");
      file("hand-ins/wrong-name/drone_final.py", PYTHON + HALF);
      file("hand-ins/java/Fly.java", JAVA);
      handIn(
          "rc",
          """
          send('command')
          send('takeoff')
          while True:
              s.sendto(b'rc 0 0 0 10', ('192.168.10.1', 8889))
              time.sleep(0.05)
          """);
    }

    @Test
    void theNineHandInsOfAClassGetTheRightTableAtOnceAndAgain() throws IOException {
      Path assignment = assignment();
      nine();
      Path results = folder.resolve("results");
      long start = System.nanoTime();

      assertThat(grade(assignment, folder.resolve("hand-ins"), "-o", results)).isZero();

      System.out.printf("nine hand-ins: %.1f s%n", (System.nanoTime() - start) * 1e-9);
      int[] verdictProgramGoalsPointsTime = {6, 7, 8, 14, 16};
      Map<String, String> rows = rows(results, verdictProgramGoalsPointsTime);
      assertThat(rows)
          .containsEntry("perfect", "reached, ended, 2, 30.0, max")
          .containsEntry("pillar", "failed, ended, 0, 0.0, max")
          .containsEntry("stays", "failed, ended, 1, 10.0, max")
          .containsEntry("loop", "missed, killed after 25 s, 0, 0.0, max")
          .containsEntry("syntax", "missed, exit 1, 0, 0.0, max")
          .containsEntry("wrong-name", "not flown, no entry file, 0, 0.0, ")
          .containsEntry("java", "missed, ended, 1, 10.0, max");
      assertThat(rows.get("slow")).startsWith("missed, ").contains(", 1, 10.0, max");
      assertThat(rows.get("rc")).startsWith("failed, killed after 25 s, 0, 0.0, real");

      byte[] json = Files.readAllBytes(results.resolve("grades.json"));
      byte[] csv = Files.readAllBytes(results.resolve("grades.csv"));
      assertThat(grade(assignment, folder.resolve("hand-ins"), "-o", results)).isZero();
      assertThat(results.resolve("grades.json")).hasBinaryContent(json);
      assertThat(grade("--regrade", results)).isZero();
      assertThat(results.resolve("grades.json")).hasBinaryContent(json);
      assertThat(results.resolve("grades.csv")).hasBinaryContent(csv);
    }

    @Test
    void shardsMakeTheResultsOfOneRun() throws IOException {
      Path assignment = assignment();
      handIn("Ann", HALF);
      handIn("Bob", "send('command')\nsend('takeoff')\nsend('land')\n");
      Path handIns = folder.resolve("hand-ins");

      for (String shard : List.of("1/2", "2/2")) {
        Path part = folder.resolve("part" + shard.charAt(0));
        assertThat(grade(assignment, handIns, "-o", part, "--shard", shard)).isZero();
      }
      Path merged = folder.resolve("merged");
      assertThat(grade("--merge", folder.resolve("part2"), folder.resolve("part1"), "-o", merged))
          .isZero();
      Path one = folder.resolve("one");
      assertThat(grade(assignment, handIns, "-o", one)).isZero();

      String wall = "\"wallSeconds\": [0-9.]+";
      assertThat(Files.readString(merged.resolve("grades.json")).replaceAll(wall, ""))
          .isEqualTo(Files.readString(one.resolve("grades.json")).replaceAll(wall, ""));
      assertThat(merged.resolve("totals.csv")).hasSameBinaryContentAs(one.resolve("totals.csv"));
    }

    /** The verdict comes in the air, or so long after the landing that the recording has ended. */
    @Test
    void verdictsOfLimitsAreTheSameAgainWithoutPoints() throws IOException {
      String goals =
          "goals:\n  - reach: {at: [200, 0, 40], radius: 30}\n  - land: {at: [0, 0], radius: 60}\n";
      file("long.yaml", goals);
      file("short.yaml", goals + "time-limit: 15\n");
      Path assignment =
          file(
              "a.yaml",
              "name: A\ncourses: [long.yaml, short.yaml]\nlimits: {wall: 25, time: 20}\n");
      String start = "send('command')\nsend('takeoff')\n";
      handIn("flier", start + "while True:\n    send('up 30')\n    send('down 30')\n");
      handIn("sleeper", start + "send('land')\ntime.sleep(100)\n");
      Path results = folder.resolve("results");

      assertThat(grade(assignment, folder.resolve("hand-ins"), "-o", results)).isZero();

      byte[] json = Files.readAllBytes(results.resolve("grades.json"));
      assertThat(verdicts(results))
          .containsExactly(
              "flier, long: missed, 0",
              "flier, short: failed, 0",
              "sleeper, long: missed, 1",
              "sleeper, short: failed, 1");
      assertThat(grade("--regrade", results)).isZero();
      assertThat(results.resolve("grades.json")).hasBinaryContent(json);
    }

    @Test
    void aProgramThatSleepsWhileItHoversReachesTheGoal() throws IOException {
      file("hover.yaml", "goals:\n  - hover: {at: [0, 0, 30], radius: 40, seconds: 2}\n");
      Path assignment = file("a.yaml", "name: A\ncourses: [hover.yaml]\nlimits: {wall: 30}\n");
      handIn("hoverer", "send('command')\nsend('takeoff')\ntime.sleep(3)\nsend('land')\n");
      Path results = folder.resolve("results");

      assertThat(grade(assignment, folder.resolve("hand-ins"), "-o", results)).isZero();

      assertThat(verdicts(results)).containsExactly("hoverer, hover: reached, 1");
    }

    private List<String> verdicts(Path results) throws IOException {
      return Grades.read(results).handIns().stream()
          .flatMap(
              handIn ->
                  handIn.flights().stream()
                      .map(
                          flight ->
                              handIn.name()
                                  + ", "
                                  + flight.course()
                                  + ": "
                                  + flight.result().verdict()
                                  + ", "
                                  + flight.result().reached()))
          .toList();
    }

    @Test
    void theOutputOfTheBuildIsKeptWhenTheProgramIsFlownAgain() throws IOException {
      file("course.yaml", COURSE);
      Path assignment = file("assignment.yaml", ASSIGNMENT + "build: ls\n");
      String twice = "s.sendto(b'rc 0 0 0 0', ('192.168.10.1', 8889))\n".repeat(2);
      handIn("Ann", "send('command')\n" + twice + "os._exit(127)\n");
      file("hand-ins/Bob/fly.py", "import os\nos._exit(127)\n");
      Path results = folder.resolve("results");

      assertThat(grade(assignment, folder.resolve("hand-ins"), "-o", results)).isZero();

      assertThat(rows(results, 7, 16))
          .containsEntry("Ann", "exit 127, real")
          .containsEntry("Bob", "did not start, max");
      assertThat(results.resolve("recordings/Ann/build.txt")).hasContent("fly.py\n");
    }

    @Test
    void aStudentSeesWhyPointsWereWon() throws IOException {
      Path assignment = assignment();
      handIn("Ann", HALF);

      assertThat(grade("--self", assignment, folder.resolve("hand-ins/Ann/fly.py"))).isZero();

      assertThat(out.toString(StandardCharsets.UTF_8))
          .contains("goals: 1 of 2; 10 of 30 points", "+10 points, reached goal 1 of 2");
    }

    /** Programs that attack cost only their own marks, and leave nothing behind. */
    @Test
    void hostileProgramsSpoilNothing() throws IOException {
      Path assignment = assignment();
      Path secret = file("secret.txt", "solution");
      handIn("bomb", "n = 0\nwhile n < 500 and os.fork(): n += 1\ntime.sleep(30)\n");
      handIn("flood", "while True: print('x' * 1000)\n");
      handIn("memory", "x = []\nwhile True: x.append(bytearray(10_000_000))\n");
      handIn(
          "shared",
          """
          import mmap
          m = mmap.mmap(-1, 2_000_000_000)
          while True: m.write(bytes(10_000_000))
          """);
      handIn(
          "disk",
          "try:\n    with open('big', 'wb') as f:\n"
              + "        while True: f.write(bytes(1000000))\nexcept OSError as e: print(e)\n"
              + HALF);
      handIn(
          "parent",
          "for p in (1, os.getppid()):\n    try: os.kill(p, signal.SIGKILL)\n"
              + "    except OSError as e: print(e)\n"
              + HALF);
      handIn(
          "stubborn",
          "signal.signal(signal.SIGTERM, signal.SIG_IGN)\n"
              + HALF
              + "os.system('(setsid sleep "
              + NAP
              + " &)')\nos.execvp('sleep', ['sleep', '"
              + NAP
              + "'])\n");
      handIn(
          "outside",
          "for p in ('/etc/evil', '/evil', '"
              + folder
              + "/evil', '"
              + Path.of("").toAbsolutePath()
              + "/evil'):\n    try:\n        open(p, 'w')\n"
              + "        print('WROTE', p)\n    except OSError as e: print(e)\n"
              + HALF);
      handIn(
          "reader",
          "for p in ('"
              + secret
              + "', '"
              + folder
              + "/hand-ins/parent/fly.py',"
              + " '"
              + System.getProperty("user.home")
              + "/.profile', '/proc/1/environ'):\n    try: print('READ', open(p).read())\n"
              + "    except OSError as e: print(e)\n"
              + HALF);
      handIn("victim", HALF);
      Path results = folder.resolve("results");

      assertThat(grade(assignment, folder.resolve("hand-ins"), "-o", results)).isZero();

      assertThat(rows(results, 6, 7, 14))
          .containsEntry("flood", "missed, killed: too much output, 0.0")
          .containsEntry("memory", "missed, killed: too much memory, 0.0")
          .containsEntry("shared", "missed, killed: too much memory, 0.0")
          .containsEntry("stubborn", "missed, stopped after the verdict, 10.0")
          .containsEntry("disk", "missed, ended, 10.0")
          .containsEntry("parent", "missed, ended, 10.0")
          .containsEntry("outside", "missed, ended, 10.0")
          .containsEntry("reader", "missed, ended, 10.0")
          .containsEntry("victim", "missed, ended, 10.0");
      assertThat(rows(results, 7).get("bomb")) // by the watch, or because the kernel refuses forks
          .isIn("killed: too many processes", "exit 1");
      assertThat(output(results, "outside")).doesNotContain("WROTE");
      assertThat(output(results, "reader")).doesNotContain("READ");
      assertThat(output(results, "disk")).contains("No space left");
      assertThat(Files.size(results.resolve("recordings/flood/course-1-1/output.txt")))
          .isLessThan(1_100_000);
      assertThat(ProcessHandle.allProcesses().filter(GradeCommandTest::naps)).isEmpty();
    }

    private String output(Path results, String name) throws IOException {
      return Files.readString(results.resolve("recordings/" + name + "/course-1-1/output.txt"));
    }
  }

  private static boolean naps(ProcessHandle process) {
    return List.of(process.info().arguments().orElse(new String[0])).contains(NAP);
  }

  private static final String JAVA =
      """
      import java.net.*;
      public class Fly {
        public static void main(String[] args) throws Exception {
          DatagramSocket socket = new DatagramSocket(9000);
          for (String text : new String[] {"command", "takeoff", "forward 100", "land"}) {
            byte[] bytes = text.getBytes();
            InetAddress drone = InetAddress.getByName("192.168.10.1");
            socket.send(new DatagramPacket(bytes, bytes.length, drone, 8889));
            DatagramPacket reply = new DatagramPacket(new byte[1000], 1000);
            socket.receive(reply);
            for (int i = 0; i < 5000; i++) {
              System.out.println(text + " " + new String(reply.getData(), 0, reply.getLength()));
            }
          }
        }
      }
      """;
}
