package tellosimulator.endurance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.benchmark.Measurement;

/** A recording whose program is killed. */
final class RecordingTrial {

  private static final double SECONDS = 5;
  private static final double PATIENCE_SECONDS = 30;

  /** What may be lost: the last second. */
  private static final int PICTURES_A_SECOND = 30;

  private RecordingTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    Path film = Files.createTempDirectory("film").resolve("killed.mp4");
    int recorded;
    try (Program recorder = Host.HERE.start(Recorder.class, film)) {
      recorded = recorded(recorder);
      long end = System.nanoTime() + (long) (SECONDS * 1e9);
      while (System.nanoTime() < end) {
        recorded = recorded(recorder);
      }
      recorder.kill();
    }
    int decoded = decode(film);
    return List.of(
        new Measurement(
            "A recording that is killed with -9, decoded by ffmpeg",
            "all but the last second",
            decoded + " of at least " + recorded + " pictures",
            decoded >= recorded - PICTURES_A_SECOND && decoded > PICTURES_A_SECOND));
  }

  private static int recorded(Program recorder) throws IOException {
    String line = recorder.await("recorded", PATIENCE_SECONDS);
    return Integer.parseInt(line.split(" ", -1)[1]);
  }

  /**
   * How many pictures ffmpeg makes of it without a complaint; -1 if it complains. By itself it
   * would leave out pictures that a busy machine took shortly after one another.
   */
  private static int decode(Path film) throws IOException {
    List<String> command = new ArrayList<>(List.of("ffmpeg", "-nostdin", "-v", "error"));
    command.addAll(List.of("-i", film.toString()));
    command.addAll(List.of("-fps_mode", "passthrough", "-f", "framecrc", "-"));
    try (Program ffmpeg = Host.HERE.start(command)) {
      List<String> lines = ffmpeg.rest(PATIENCE_SECONDS);
      if (!ffmpeg.errors().isEmpty()) {
        System.out.println(ffmpeg.errors());
        return -1;
      }
      return (int) lines.stream().filter(line -> !line.startsWith("#")).count();
    }
  }
}
