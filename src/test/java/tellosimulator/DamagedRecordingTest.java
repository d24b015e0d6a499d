package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.recording.RecordingFile;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/**
 * Each subcommand works with any content of a recording, or explains in a sentence why it does not.
 */
class DamagedRecordingTest {

  private static final Pattern NUMBER = Pattern.compile("-?[0-9]+(\\.[0-9]+)?");

  private static final List<String> EXTREMES =
      List.of("-1", "1e300", "-1e300", "9223372036854775807", "1e-300");

  private static final String WIRE =
      """
      {"t":1.0,"drone":1,"kind":"command","from":"127.0.0.1:50000","to":"127.0.0.1:8889","text":"command"}
      {"t":4.0,"drone":1,"kind":"command","from":"127.0.0.1:50000","to":"127.0.0.1:8889","text":"takeoff"}
      {"t":4.1,"drone":1,"kind":"state","from":"127.0.0.1:8889","to":"127.0.0.1:8890","text":"mid:-2;yaw:-26;vgx:1;vgy:0;vgz:0;h:80;baro:1.50;\\r\\n"}
      {"t":4.5,"drone":1,"kind":"video","from":"127.0.0.1:6038","to":"127.0.0.1:11111","size":1460,"sha256":"00"}
      """;

  @TempDir private Path folder;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private Path recording() {
    Path made = RecordingFixture.in(folder.resolve("flight"));
    new RecordingFixture(made).with("wire.jsonl", WIRE);
    return made;
  }

  private int run(String... words) {
    out.reset();
    err.reset();
    return Main.run(
        words,
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  private String told() {
    return err.toString(StandardCharsets.UTF_8);
  }

  private String printed() {
    return out.toString(StandardCharsets.UTF_8);
  }

  private int export(Path from, String format) {
    return run("export", from.toString(), "--to", format, "-o", folder.resolve("out").toString());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"1500-01-01T00:00:00Z", "9999-12-31T23:59:59Z", "-999999999-01-01T00:00Z", "x"})
  void aTakeoffAtAnImpossibleMomentIsExportedAllTheSame(String begun) {
    Path flight = recording();
    new RecordingFixture(flight).runWith("2026-03-01T10:00:00Z", begun);

    assertThat(export(flight, "pcap")).isZero();
    assertThat(export(flight, "mcap")).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"run.json", "events.jsonl", "wire.jsonl", "flight.csv", "goals.json"})
  @Tag("slow")
  void extremeNumbersAreNoFault(String file) throws IOException {
    Path flight = recording();
    String text = Files.readString(flight.resolve(file));
    String begin = text.lines().limit(5).reduce("", (all, line) -> all + line + "\n");
    Matcher number = NUMBER.matcher(begin);
    int index = 0;
    while (number.find()) {
      String extreme = EXTREMES.get(index % EXTREMES.size());
      index++;
      String damaged = text.substring(0, number.start()) + extreme + text.substring(number.end());
      new RecordingFixture(flight).with(file, damaged);
      for (String format : List.of("pcap", "mcap")) {
        assertSentence(export(flight, format), damaged);
      }
      String page = folder.resolve("page.html").toString();
      assertSentence(run("diff", flight.toString(), flight.toString(), "-o", page), damaged);
      if (index % 4 == 0) { // the slowest one
        assertSentence(run("report", flight.toString(), "-o", page), damaged);
        assertSentence(run("replay", flight.toString()), damaged);
      }
    }
  }

  private void assertSentence(int code, String damaged) {
    assertThat(code).as(damaged).isIn(0, 1, 4);
    assertThat(told()).as(damaged).doesNotContain("report this", "Exception");
  }

  @Test
  void textThatIsNotUtf8IsASentence() throws IOException {
    Path flight = recording();
    Files.write(flight.resolve("run.json"), new byte[] {'{', '"', (byte) 0xff, '"', '}'});

    assertThat(run("report", flight.toString())).isEqualTo(1);

    assertThat(told())
        .isEqualToIgnoringNewLines(
            flight.resolve("run.json") + " cannot be read: it is no text in UTF-8.");
  }

  @Test
  void aRunThatIsFarTooLargeIsASentence() throws IOException {
    Path flight = recording();
    new RecordingFixture(flight).with("run.json", "[" + " ".repeat(5 << 20) + "]");

    assertThat(run("export", flight.toString(), "--to", "pcap")).isEqualTo(1);

    assertThat(told())
        .isEqualToIgnoringNewLines(
            flight.resolve("run.json") + " cannot be read: it is larger than 4 MB.");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"wire.jsonl", "events.jsonl", "flight.csv", "goals.json", "scenario.yaml"})
  void aFolderInThePlaceOfAFileIsRemarked(String file) throws IOException {
    Path flight = recording();
    Files.deleteIfExists(flight.resolve(file));
    Files.createDirectory(flight.resolve(file));

    assertIrregular(flight, file);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"wire.jsonl", "events.jsonl", "flight.csv", "goals.json", "scenario.yaml"})
  @DisabledOnOs(OS.WINDOWS)
  @NeedsTool(Tool.MKFIFO)
  void aPipeInThePlaceOfAFileIsRemarked(String file) throws Exception {
    Path flight = recording();
    Files.deleteIfExists(flight.resolve(file));
    assertThat(Tool.MKFIFO.command(flight.resolve(file).toString()).start().waitFor()).isZero();

    assertIrregular(flight, file);
  }

  private void assertIrregular(Path flight, String file) {
    String remark = "remark: " + flight + ": " + file + " cannot be read and is left out";
    Path page = folder.resolve("page.html");
    boolean wire = file.equals("wire.jsonl");

    assertThat(run("report", flight.toString(), "-o", page.toString())).isZero();
    if (!wire) { // a report needs it only if there are no events
      assertThat(printed()).contains(remark);
    }
    assertThat(export(flight, "pcap")).isEqualTo(wire ? 1 : 0);
    if (wire) {
      assertThat(told())
          .contains(flight.resolve(file) + " cannot be read: it is a folder, a pipe or a device");
      assertThat(folder.resolve("out")).doesNotExist();
    }
  }

  @Test
  void thereIsNoExportOfNothing() throws IOException {
    Path flight = recording();
    for (RecordingFile file : RecordingFile.values()) {
      if (file != RecordingFile.RUN) {
        Files.deleteIfExists(file.in(flight));
      }
    }

    assertThat(export(flight, "pcap")).isEqualTo(1);
    assertThat(told()).contains("no datagram of it is known");
    assertThat(export(flight, "mcap")).isEqualTo(1);
    assertThat(folder.resolve("out")).doesNotExist();
  }

  @Test
  void aRecordingIsNamedByItsFolderOrByItsRun() {
    Path flight = recording();
    String run = flight.resolve("run.json").toString();

    for (String named : List.of(flight.toString(), run)) {
      assertThat(run("report", named)).isZero();
      assertThat(run("export", named, "--to", "pcap")).isZero();
      assertThat(run("export", named, "--to", "mcap")).isZero();
      assertThat(run("diff", named, run)).isZero();
      assertThat(run("replay", named)).isIn(0, 4);
    }
    assertThat(flight.resolve("report.html")).exists();
    assertThat(flight.resolve("flight.pcap")).exists();
  }

  @Test
  void nothingFromOutsideCommandsTheTerminal() throws IOException {
    String hostile = "a\u001b]0;title\u0007\u202eb";
    Path flight = recording();
    Path named;
    try {
      named = Files.move(flight, folder.resolve(hostile));
    } catch (java.nio.file.InvalidPathException | IOException e) {
      named = flight; // not every file system permits such names
    }
    new RecordingFixture(named)
        .runWith("\"program\":\"1.0.0\"", "\"program\":\"1\\u001b[2J\\u202e\"")
        .with(
            "events.jsonl",
            Files.readString(named.resolve("events.jsonl")).replace("land", "l\\u001b\\u202ed"));
    String missing = folder.resolve("missing" + (named.equals(flight) ? "" : hostile)).toString();

    for (String[] words :
        Stream.of(
                "report\n%s",
                "export\n%s\n--to\npcap",
                "replay\n%s",
                "diff\n%s\n%s",
                "report\n" + missing,
                "--replay\n" + missing,
                "--scenario\n" + missing + ".yaml",
                "\u001b[2J\u202e",
                "--profile\n\u001b[2J\u202e")
            .map(line -> line.replace("%s", named(flight, hostile)).split("\n"))
            .toList()) {
      run(words);
      assertThat(printed() + told())
          .as(String.join(" ", words))
          .isNotEmpty()
          .doesNotContain("\u001b", "\u202e", "\u0007");
    }
  }

  private String named(Path flight, String hostile) {
    return (Files.exists(flight) ? flight : folder.resolve(hostile)).toString();
  }
}
