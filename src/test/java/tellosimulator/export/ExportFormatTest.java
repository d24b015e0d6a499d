package tellosimulator.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.testing.AppPackets;

/**
 * Reads the files back according to their format specifications; ExportToolsIT uses other tools.
 */
class ExportFormatTest {

  private static final String WIRE =
      """
      {"t":1.0,"drone":1,"kind":"command","from":"127.0.0.1:50000","to":"127.0.0.1:8889","text":"command"}
      {"t":4.0,"drone":1,"kind":"state","from":"127.0.0.1:8889","to":"127.0.0.1:8890","text":"mid:-2;mpry:0,0,0;yaw:-26;h:80;baro:1.50;\\r\\n"}
      {"t":4.5,"drone":1,"kind":"video","from":"127.0.0.1:6038","to":"127.0.0.1:11111","size":1460,"sha256":"00"}
      {"t":5.0,"drone":1,"kind":"reply","from":"somewhere:1","to":"127.0.0.1:99999","text":"ok"}
      {"t":6.0,"drone":1,"ki""";

  @TempDir private Path folder;

  @BeforeEach
  void record() {
    RecordingFixture.in(folder);
    new RecordingFixture(folder).with("wire.jsonl", WIRE);
  }

  private ByteBuffer exported(ExportFormat format)
      throws IOException, UnreadableRecordingException {
    Path file = folder.resolve("flight." + format.word());
    format.export(folder, RecordedFlight.read(folder), file);
    return ByteBuffer.wrap(Files.readAllBytes(file));
  }

  @Test
  void aCaptureHasTheDatagramsAtTheTimesOfTheSimulation() throws Exception {
    ByteBuffer pcap = exported(ExportFormat.PCAP);

    assertThat(pcap.getInt()).isEqualTo(0xa1b2c3d4);
    assertThat(pcap.getShort(4)).isEqualTo((short) 2);
    assertThat(pcap.getInt(20)).as("IPv4").isEqualTo(228);
    pcap.position(24);
    List<String> packets = new ArrayList<>();
    while (pcap.hasRemaining()) {
      packets.add(packet(pcap));
    }
    // the takeoff at 4 s was at 2026-03-01T10:00:00Z
    assertThat(packets)
        .containsExactly(
            "1772359197.000000 7f000001:50000 to 7f000001:8889 35 of 35 command",
            "1772359200.000000 7f000001:8889 to 7f000001:8890 71 of 71 mid:-2;mpry:0,0,0;yaw:-26;h:80;baro:1.50;",
            "1772359200.500000 7f000001:6038 to 7f000001:11111 28 of 1488");
  }

  private static String packet(ByteBuffer pcap) {
    int seconds = pcap.getInt();
    int micros = pcap.getInt();
    int kept = pcap.getInt();
    int length = pcap.getInt();
    int ip = pcap.position();
    int sum = 0;
    for (int i = 0; i < 20; i += 2) {
      sum += pcap.getShort(ip + i) & 0xffff;
    }
    assertThat((sum & 0xffff) + (sum >> 16)).as("checksum of the header").isEqualTo(0xffff);
    assertThat(pcap.getShort(ip + 2) & 0xffff).isEqualTo(length);
    assertThat(pcap.getShort(ip + 24) & 0xffff).isEqualTo(length - 20);
    byte[] payload = new byte[kept - 28];
    pcap.get(ip + 28, payload);
    String text =
        String.format(
            "%d.%06d %08x:%d to %08x:%d %d of %d %s",
            seconds,
            micros,
            pcap.getInt(ip + 12),
            pcap.getShort(ip + 20) & 0xffff,
            pcap.getInt(ip + 16),
            pcap.getShort(ip + 22) & 0xffff,
            kept,
            length,
            new String(payload, StandardCharsets.ISO_8859_1));
    pcap.position(ip + kept);
    return text.strip();
  }

  @Test
  void packetsOfTheAppHaveWords() throws Exception {
    new RecordingFixture(folder)
        .with(
            "wire.jsonl",
            Json.text(Map.of("t", 1, "drone", 1, "kind", "command", "text", AppPackets.TAKEOFF))
                + "\n");
    Path file = folder.resolve("app.mcap");
    ExportFormat.MCAP.export(folder, RecordedFlight.readOutline(folder), file);

    assertThat(Files.readString(file, StandardCharsets.ISO_8859_1))
        .contains("\"words\": \"takeoff (app)\"");
  }

  @Test
  void messagesHaveChannelsWithSchemas() throws Exception {
    ByteBuffer mcap = exported(ExportFormat.MCAP).order(ByteOrder.LITTLE_ENDIAN);

    byte[] magic = new byte[8];
    mcap.get(magic);
    assertThat(magic).containsExactly(0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n');
    List<String> topics = new ArrayList<>();
    List<String> states = new ArrayList<>();
    int last = -1;
    while (mcap.remaining() > 8) {
      last = mcap.get();
      int end = mcap.position() + 8 + (int) mcap.getLong(mcap.position());
      mcap.position(mcap.position() + 8);
      if (last == 4) {
        mcap.position(mcap.position() + 4);
        topics.add(text(mcap));
      } else if (last == 5 && topics.get(mcap.getShort() - 1).equals("/drone1/state")) {
        mcap.position(mcap.position() + 4);
        long nanos = mcap.getLong();
        byte[] json = new byte[end - mcap.position() - 8];
        mcap.get(mcap.position() + 8, json);
        states.add(nanos + " " + new String(json, StandardCharsets.UTF_8));
      }
      mcap.position(end);
    }
    mcap.get(magic);
    assertThat(last).as("a footer at the end").isEqualTo(2);
    assertThat(magic).startsWith(0x89, 'M');
    assertThat(topics).containsExactly("/drone1/truth", "/events", "/wire", "/drone1/state");
    assertThat(states)
        .containsExactly(
            "1772359200000000000 {\"mid\": -2.0, \"yaw\": -26.0, \"h\": 80.0, \"baro\": 1.5}");
  }

  private static String text(ByteBuffer mcap) {
    byte[] bytes = new byte[mcap.getInt()];
    mcap.get(bytes);
    return new String(bytes, StandardCharsets.UTF_8);
  }
}
