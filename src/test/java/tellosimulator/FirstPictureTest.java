package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.video.VideoReceiver;

/**
 * Checks that with time factor {@code max}, the first picture of each stream has the same bytes in
 * each run: over real sockets, from a separate process, however busy the machine is.
 */
@Tag("process")
@Tag("slow")
@Timeout(value = 300, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class FirstPictureTest {

  private static final int RUNS = 3;

  /** Threads that only keep the processors busy. */
  private static final int LOAD = 2;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "command,takeoff,streamon",
        "command,takeoff,up 50,cw 35,forward 60,streamon,streamoff,right 40,streamon"
      })
  void theFirstPictureOfAStreamIsTheSameInEachRun(String program) throws Exception {
    Set<String> pictures = new HashSet<>();
    AtomicBoolean over = new AtomicBoolean();
    try {
      for (int i = 0; i < LOAD; i++) {
        Thread busy = new Thread(() -> spin(over), "load");
        busy.setDaemon(true);
        busy.start();
      }
      for (int run = 0; run < RUNS; run++) {
        pictures.add(picture(List.of(program.split(",", -1))));
      }
    } finally {
      over.set(true);
    }

    assertThat(pictures).hasSize(1);
  }

  private static void spin(AtomicBoolean over) {
    while (!over.get()) {
      Thread.onSpinWait();
    }
  }

  /** Returns the first frame after the last command, as hexadecimal digits. */
  private static String picture(List<String> program) throws IOException {
    try (VideoReceiver video = VideoReceiver.open(0);
        ProgramProcess process =
            ProgramProcess.start(
                Main.class,
                "--headless --time-factor max --seed 3 --video-port " + video.port(),
                "")) {
      int port = process.port();
      for (String command : program) {
        assertThat(ProgramProcess.ask(command, port)).isEqualTo("ok");
        if (command.equals("streamoff")) {
          assertThat(video.fallsSilent()).isTrue();
        }
      }
      byte[] unit = video.nextSps();
      while (VideoReceiver.type(unit) != VideoReceiver.IDR) {
        unit = video.unit();
      }
      return HexFormat.of().formatHex(unit);
    }
  }
}
