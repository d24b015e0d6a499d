package tellosimulator.benchmark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import tellosimulator.video.picture.Picture;

/**
 * Software camera and encoder on the pictures of the recorded flight, on one core; beside them, in
 * the same run, JCodec's encoder as it comes, and x264 at its fastest.
 */
final class VideoBenchmark {

  private static final int WARM_UPS = 2;
  private static final int RUNS = 8;

  /** How much worse than x264 pictures may be [dB]. */
  private static final double WORSE = 1.5;

  private final FlightRenderer renderer = new FlightRenderer();
  private final boolean decodable = FfmpegFilms.available();
  private final FfmpegFilms ffmpeg;
  private final List<Measurement> rows = new ArrayList<>();
  private final List<Double> least = new ArrayList<>();
  private final List<Double> all = new ArrayList<>();
  private final List<Double> jcodecs = new ArrayList<>();

  private VideoBenchmark(Path folder) {
    ffmpeg = new FfmpegFilms(folder);
  }

  static List<Measurement> all() throws IOException {
    Path folder = Files.createTempDirectory("films");
    try {
      return new VideoBenchmark(folder).rows();
    } finally {
      try (Stream<Path> files = Files.list(folder)) {
        for (Path file : files.toList()) {
          Files.delete(file);
        }
      }
      Files.delete(folder);
    }
  }

  private List<Measurement> rows() throws IOException {
    for (int i = 0; i < WARM_UPS; i++) {
      for (FlightPart part : FlightPart.values()) {
        renderer.times(part);
      }
    }
    for (FlightPart part : FlightPart.values()) {
      camera(part);
    }
    for (FlightPart part : FlightPart.values()) {
      part(part);
    }
    Statistics times = new Statistics(all);
    rows.add(
        Measurement.atMost(
            "Encoding a picture of 960 × 720 on one core, " + RUNS + " times each, median",
            10,
            times.median()));
    rows.add(Measurement.atMost("… 99th percentile", 15, times.quantile(0.99)));
    Statistics best = new Statistics(least);
    rows.add(
        Measurement.beside(
            "… best of the " + RUNS + " times, median and 99th percentile",
            String.format(Locale.ROOT, "%.1f ms, %.1f ms", best.median(), best.quantile(0.99))));
    rows.add(
        Measurement.beside(
            "… JCodec's encoder as it comes, median",
            String.format(Locale.ROOT, "%.1f ms", new Statistics(jcodecs).median())));
    return rows;
  }

  private void camera(FlightPart part) {
    Statistics times = new Statistics(renderer.times(part));
    rows.add(
        Measurement.atMost(
            "Software camera, a picture of 960 × 720 on one core, " + part.word() + ", median",
            8,
            times.median()));
  }

  private void part(FlightPart part) throws IOException {
    List<Picture> pictures = renderer.pictures(part);
    for (int i = 0; i < WARM_UPS; i++) {
      EncodedFilm.ours(pictures);
    }
    EncodedFilm film = EncodedFilm.ours(pictures);
    encode(pictures);
    EncodedFilm jcodec = EncodedFilm.jcodecs(pictures);
    jcodecs.addAll(jcodec.times());
    if (decodable) {
      EncodedFilm x264 = ffmpeg.x264(pictures);
      OptionalDouble best = ffmpeg.psnr(x264, pictures);
      OptionalDouble theirs = ffmpeg.psnr(jcodec, pictures);
      quality(part, film, ffmpeg.psnr(film, pictures).orElse(0), floor(best, theirs));
      rows.add(Measurement.beside("… x264 ultrafast, zerolatency", figures(x264, best)));
      rows.add(Measurement.beside("… JCodec's encoder", figures(jcodec, theirs)));
    } else {
      rows.add(
          new Measurement(
              quality(part), "", "no ffmpeg here to decode and to compare with", false));
    }
  }

  /**
   * Encodes a part several times. The least time of each picture depends on what is encoded alone:
   * on a shared machine others take half as long again, for tenths of a second to many seconds at a
   * time.
   */
  private void encode(List<Picture> pictures) {
    List<List<Double>> runs = new ArrayList<>();
    for (int i = 0; i < RUNS; i++) {
      runs.add(EncodedFilm.ours(pictures).times());
    }
    runs.forEach(all::addAll);
    for (int i = 0; i < pictures.size(); i++) {
      int picture = i;
      least.add(runs.stream().mapToDouble(times -> times.get(picture)).min().orElseThrow());
    }
  }

  /** The least that is good enough [dB]. */
  private static double floor(OptionalDouble x264, OptionalDouble jcodec) {
    return Math.max(x264.orElseThrow() - WORSE, jcodec.orElse(0));
  }

  private void quality(FlightPart part, EncodedFilm film, double psnr, double floor) {
    rows.add(
        new Measurement(
            quality(part),
            String.format(Locale.ROOT, "at least %.1f dB", floor),
            figures(film, OptionalDouble.of(psnr)),
            psnr >= floor));
  }

  private static String quality(FlightPart part) {
    return "Luma PSNR at 2.5 Mbit/s, " + part.word();
  }

  private static String figures(EncodedFilm film, OptionalDouble psnr) {
    return String.format(
        Locale.ROOT,
        "%s at %.2f Mbit/s",
        psnr.isPresent() ? String.format(Locale.ROOT, "%.1f dB", psnr.getAsDouble()) : "broken",
        film.megabitsPerSecond());
  }
}
