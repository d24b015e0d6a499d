package tellosimulator.benchmark;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import tellosimulator.video.picture.Picture;

/** What the program ffmpeg makes of films, in a folder of files in between. */
final class FfmpegFilms {

  private final Path folder;

  FfmpegFilms(Path folder) {
    this.folder = folder;
  }

  /** Whether there is such a program. */
  static boolean available() {
    try {
      return run("ffmpeg", "-version") == 0;
    } catch (IOException e) {
      return false;
    }
  }

  /** By x264 at its fastest, on one core. */
  EncodedFilm x264(List<Picture> pictures) throws IOException {
    Path raw = folder.resolve("film.yuv");
    try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(raw))) {
      for (Picture picture : pictures) {
        out.write(picture.y());
        out.write(picture.u());
        out.write(picture.v());
      }
    }
    String size = pictures.get(0).width() + "x" + pictures.get(0).height();
    String rate = "" + EncodedFilm.PICTURES_PER_SECOND;
    Path stream = folder.resolve("film.264");
    List<String> command = new ArrayList<>(List.of("ffmpeg", "-nostdin", "-v", "error"));
    command.addAll(List.of("-f", "rawvideo", "-pix_fmt", "yuv420p", "-s", size, "-r", rate));
    command.addAll(List.of("-i", raw.toString(), "-c:v", "libx264", "-preset", "ultrafast"));
    command.addAll(List.of("-tune", "zerolatency", "-threads", "1", "-g", rate));
    command.addAll(List.of("-b:v", "" + EncodedFilm.BITS_PER_SECOND, "-y", stream.toString()));
    int status = run(command.toArray(String[]::new));
    if (status != 0) {
      throw new IOException("ffmpeg ended with " + status);
    }
    return new EncodedFilm(Files.readAllBytes(stream), pictures.size(), List.of());
  }

  /** How near a film's brightness comes to its pictures, decoded: PSNR over all of it [dB]. */
  OptionalDouble psnr(EncodedFilm film, List<Picture> pictures) throws IOException {
    Path stream = Files.write(folder.resolve("film.264"), film.stream());
    Path decoded = folder.resolve("decoded.yuv");
    run(
        "ffmpeg",
        "-nostdin",
        "-v",
        "error",
        "-f",
        "h264",
        "-i",
        stream.toString(),
        "-fps_mode",
        "passthrough",
        "-f",
        "rawvideo",
        "-pix_fmt",
        "yuv420p",
        "-y",
        decoded.toString());
    double squares = 0;
    int count = 0;
    try (InputStream in = new BufferedInputStream(Files.newInputStream(decoded))) {
      for (Picture picture : pictures) {
        byte[] seen = in.readNBytes(picture.y().length);
        if (seen.length < picture.y().length) {
          break;
        }
        in.skipNBytes(2L * picture.u().length);
        squares += squares(picture.y(), seen);
        count++;
      }
    }
    if (count < pictures.size()) {
      return OptionalDouble.empty();
    }
    double mean = squares / count / pictures.get(0).y().length;
    return OptionalDouble.of(10 * Math.log10(255 * 255 / mean));
  }

  private static double squares(byte[] wanted, byte[] seen) {
    long sum = 0;
    for (int i = 0; i < wanted.length; i++) {
      int difference = (wanted[i] & 0xFF) - (seen[i] & 0xFF);
      sum += (long) difference * difference;
    }
    return sum;
  }

  private static int run(String... command) throws IOException {
    try {
      return new ProcessBuilder(command)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .redirectError(ProcessBuilder.Redirect.INHERIT)
          .start()
          .waitFor();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException(e);
    }
  }
}
