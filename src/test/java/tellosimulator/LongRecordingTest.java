package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.testing.Jvm;

/**
 * Processes a recording that is many times larger than the memory: three hours in which a program
 * steers without a pause.
 */
@Tag("process")
@Tag("slow")
@Timeout(value = 600, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class LongRecordingTest {

  private static final int SECONDS = 3 * 3600;

  @TempDir private static Path folder;

  private static Path flight;

  @BeforeAll
  static void record() throws IOException {
    flight = RecordingFixture.in(folder.resolve("flight"));
    Files.delete(flight.resolve("goals.json"));
    new RecordingFixture(flight).runWith("\"ended\":15.0", "\"ended\":" + SECONDS + ".0");
    try (BufferedWriter wire = Files.newBufferedWriter(flight.resolve("wire.jsonl"));
        BufferedWriter events = Files.newBufferedWriter(flight.resolve("events.jsonl"));
        BufferedWriter table = Files.newBufferedWriter(flight.resolve("flight.csv"))) {
      table.write(
          "t_s,drone,x_cm,y_cm,z_cm,roll_deg,pitch_deg,heading_deg,phase,battery_pct,command\n");
      for (int tick = 80; tick < SECONDS * 20; tick++) {
        double time = tick / 20.0;
        double x = 100 * Math.sin(time / 10);
        table.write(
            String.format(
                Locale.ROOT, "%.3f,1,%.2f,0,80,0,0,0,flying,90,\"rc %d\"\n", time, x, tick % 7));
        if (tick % 2 == 0) {
          wire.write(
              String.format(
                  Locale.ROOT,
                  "{\"t\":%.3f,\"drone\":1,\"kind\":\"state\",\"from\":\"127.0.0.1:8889\","
                      + "\"to\":\"127.0.0.1:8890\",\"text\":\"yaw:0;vgx:%d;vgy:0;vgz:0;h:80;\"}\n",
                  time,
                  Math.round(x / 10)));
        }
        if (tick % 5 == 0) {
          command(wire, events, time, tick / 5);
        }
      }
    }
  }

  /** Writes mostly {@code rc}, and a read every two seconds. */
  private static void command(BufferedWriter wire, BufferedWriter events, double time, int number)
      throws IOException {
    String text = number % 8 == 0 ? "battery?" : "rc 0 0 0 " + number % 100;
    wire.write(line("\"kind\":\"command\",\"text\":\"%s\"", time, text));
    events.write(
        line(
            "\"kind\":\"command\",\"severity\":\"detail\",\"command\":\"%s\",\"number\":%d",
            time, text, number));
    if (number % 8 == 0) {
      wire.write(line("\"kind\":\"reply\",\"text\":\"90\"", time));
      events.write(
          line(
              "\"kind\":\"reply\",\"severity\":\"detail\",\"command\":\"%s\",\"number\":%d,\"reply\":\"90\"",
              time, text, number));
    }
  }

  private static String line(String form, double time, Object... values) {
    return String.format(Locale.ROOT, "{\"t\":%.3f,\"drone\":1,", time)
        + String.format(Locale.ROOT, form, values)
        + "}\n";
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "report FLIGHT -o FOLDER/report.html",
        "diff FLIGHT FLIGHT -o FOLDER/diff.html",
        "export FLIGHT --to mcap -o FOLDER/flight.mcap",
        "export FLIGHT --to pcap -o FOLDER/flight.pcap"
      })
  void aRecordingOfHoursNeedsLittleMemory(String words) throws Exception {
    List<String> arguments = new ArrayList<>();
    for (String word : words.split(" ", -1)) {
      arguments.add(word.replace("FLIGHT", flight.toString()).replace("FOLDER", folder.toString()));
    }
    List<String> command = Jvm.commandOf(Main.class, arguments.toArray(String[]::new));
    command.add(1, "-Xmx128m");
    Path log = folder.resolve("log.txt");

    Process process =
        Jvm.process(command).redirectErrorStream(true).redirectOutput(log.toFile()).start();

    assertThat(process.waitFor()).as("%s", Files.readString(log)).isZero();
    Path written = Path.of(arguments.get(arguments.size() - 1));
    if (written.toString().endsWith(".html")) {
      assertThat(Files.size(written)).as("a page that a browser opens").isLessThan(12_000_000);
    }
  }
}
