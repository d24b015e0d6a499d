package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.concurrent.FatalExit;
import tellosimulator.testing.HungryProgram;

/** Checks that with too little memory, the program reports this, and never continues in part. */
@Tag("process")
@Timeout(
    value = 4 * ProgramProcess.PATIENCE_SECONDS,
    unit = TimeUnit.SECONDS,
    threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@Tag("slow")
class ScarceMemoryTest {

  private static final String END = "The simulator ends, because its memory is full.";

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  /** Several seconds of datagrams from a host that does not operate the drone. */
  private static final int FLOOD = 200_000;

  @Test
  void videoWithoutMemoryHarmsNothingElse() throws Exception {
    try (DatagramSocket video = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0));
        ProgramProcess program =
            scarce("-Xmx25m", "--time-factor max --video-port " + video.getLocalPort())) {
      int port = program.port();
      assertThat(reply("command", program, port)).isEqualTo("ok");
      for (int i = 0; i < 2; i++) {
        assertThat(reply("streamon", program, port)).isEqualTo("ok");
        awaitVideoOrSentence(video, program);
        assertThat(reply("command", program, port)).isEqualTo("ok");
        assertThat(reply("streamoff", program, port)).isEqualTo("ok");
      }
      assertThat(reply("takeoff", program, port)).isEqualTo("ok");
      assertThat(reply("land", program, port)).isEqualTo("ok");
    }
  }

  @Test
  void videoFliesInThirtyTwoMegabytes() throws Exception {
    try (DatagramSocket video = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0));
        ProgramProcess program =
            scarce("-Xmx32m", "--time-factor max --video-port " + video.getLocalPort())) {
      int port = program.port();
      assertThat(reply("command", program, port)).isEqualTo("ok");
      assertThat(reply("streamon", program, port)).isEqualTo("ok");
      awaitVideoOrSentence(video, program);

      assertThat(reply("takeoff", program, port)).isEqualTo("ok");
      assertThat(program.errors()).doesNotContain("rests until");
    }
  }

  /**
   * Returns the reply to a text, which is sent again every few seconds, as programs do, because a
   * step without enough memory loses its input. Without a reply, fails with the program's output.
   */
  private static String reply(String text, ProgramProcess program, int port) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    try (DatagramSocket client = new DatagramSocket()) {
      client.setSoTimeout(5000);
      for (int i = 0; i < ProgramProcess.PATIENCE_SECONDS / 5 && program.isAlive(); i++) {
        client.send(new DatagramPacket(bytes, bytes.length, LOOPBACK, port));
        try {
          DatagramPacket reply = new DatagramPacket(new byte[100], 100);
          client.receive(reply);
          return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII);
        } catch (SocketTimeoutException e) {
          // lost, or not answered yet
        }
      }
    }
    throw new AssertionError(
        "no reply to " + text + ", alive: " + program.isAlive() + "; " + program.errors());
  }

  private static void awaitVideoOrSentence(DatagramSocket video, ProgramProcess program)
      throws IOException {
    video.setSoTimeout(100);
    while (!program.errors().contains("The video of drone 1 rests until the next streamon")) {
      try {
        video.receive(new DatagramPacket(new byte[2048], 2048));
        return;
      } catch (SocketTimeoutException e) {
        assertThat(program.isAlive()).as(program.errors()).isTrue();
      }
    }
  }

  @Test
  void underAFloodItSurvivesOrSaysThatItEnds() throws Exception {
    try (ProgramProcess program = scarce("-Xmx24m", "--log-level info")) {
      int port = program.port();
      assertThat(ProgramProcess.ask("command", port)).isEqualTo("ok");
      flood(port);

      if (!answers(program, port)) {
        assertThat(program.exitCode()).isEqualTo(FatalExit.CODE);
        assertThat(program.errors()).contains(END);
      }
    }
  }

  /**
   * Returns whether the program answers; asks several times, because a flood displaces other
   * datagrams.
   */
  private static boolean answers(ProgramProcess program, int port) throws IOException {
    try (DatagramSocket client = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0))) {
      client.setSoTimeout(1000);
      byte[] bytes = "command".getBytes(StandardCharsets.US_ASCII);
      for (int i = 0; i < ProgramProcess.PATIENCE_SECONDS && program.isAlive(); i++) {
        client.send(new DatagramPacket(bytes, bytes.length, LOOPBACK, port));
        try {
          client.receive(new DatagramPacket(new byte[100], 100));
          return true;
        } catch (SocketTimeoutException e) {
          // lost, or the program is about to end
        }
      }
      return false;
    }
  }

  @Test
  void memoryThatStaysFullEndsItWithASentenceAndACodeOfItsOwn() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(HungryProgram.class, "--headless", "", "-Xmx64m")) {
      assertThat(ProgramProcess.ask("command", program.port())).isEqualTo("ok");

      program.type("eat\n");

      assertThat(program.exitCode()).isEqualTo(FatalExit.CODE);
      assertThat(program.errors()).contains(END);
    }
  }

  private static ProgramProcess scarce(String heap, String options) throws IOException {
    return ProgramProcess.start(Main.class, "--headless " + options, "", heap);
  }

  private static void flood(int port) throws IOException {
    byte[] junk = "q".repeat(2000).getBytes(StandardCharsets.US_ASCII);
    byte[] query = "battery?".getBytes(StandardCharsets.US_ASCII);
    try (DatagramSocket stranger = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0))) {
      for (int i = 0; i < FLOOD; i++) {
        byte[] bytes = i % 2 == 0 ? junk : query;
        try {
          stranger.send(new DatagramPacket(bytes, bytes.length, LOOPBACK, port));
        } catch (IOException e) {
          return; // the port is closed: the program has ended
        }
      }
    }
  }
}
