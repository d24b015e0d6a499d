package tellosimulator.conformance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.export.ExportFormat;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Checks exported recordings with third-party tools. */
@Timeout(120)
class ExportToolsIT {

  private static final String WIRE =
      """
      {"t":4.0,"drone":1,"kind":"command","from":"127.0.0.1:50000","to":"127.0.0.1:8889","text":"takeoff"}
      {"t":5.5,"drone":1,"kind":"video","from":"127.0.0.1:6038","to":"127.0.0.1:11111","size":1460,"sha256":"00"}
      {"t":7.0,"drone":1,"kind":"reply","from":"127.0.0.1:8889","to":"127.0.0.1:50000","text":"ok"}
      """;

  private static final String COUNT =
      """
      import sys
      from mcap.reader import make_reader
      counts = {}
      with open(sys.argv[1], "rb") as file:
          for schema, channel, message in make_reader(file).iter_messages():
              counts[channel.topic] = counts.get(channel.topic, 0) + 1
      print(sorted(counts.items()))
      """;

  @TempDir private Path folder;

  private Path exported(ExportFormat format) throws Exception {
    RecordingFixture.in(folder);
    new RecordingFixture(folder).with("wire.jsonl", WIRE);
    Path file = folder.resolve("flight." + format.word());
    format.export(folder, RecordedFlight.read(folder), file);
    return file;
  }

  @Test
  @NeedsTool(Tool.TSHARK)
  void wiresharkReadsTheCapture() throws Exception {
    String file = exported(ExportFormat.PCAP).toString();

    assertThat(
            output(
                Tool.TSHARK.command(
                    "-r",
                    file,
                    "-o",
                    "ip.check_checksum:TRUE",
                    "-T",
                    "fields",
                    "-e",
                    "ip.checksum.status",
                    "-e",
                    "udp.srcport",
                    "-e",
                    "udp.dstport",
                    "-e",
                    "udp.length",
                    "-e",
                    "frame.time_relative")))
        .containsExactly(
            "1\t50000\t8889\t15\t0.000000000",
            "1\t6038\t11111\t1468\t1.500000000",
            "1\t8889\t50000\t10\t3.000000000");
  }

  @Test
  @NeedsTool(Tool.PYTHON_CLIENTS)
  void theMcapPackageReadsTheMessages() throws Exception {
    String file = exported(ExportFormat.MCAP).toString();
    assertThat(output(Tool.PYTHON_CLIENTS.command("-c", COUNT, file)))
        .containsExactly("[('/drone1/truth', 221), ('/events', 18), ('/wire', 3)]");
  }

  private static List<String> output(ProcessBuilder command)
      throws IOException, InterruptedException {
    Process process = command.redirectError(ProcessBuilder.Redirect.DISCARD).start();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(String.join(" ", command.command())).isZero();
    return output.lines().toList();
  }
}
