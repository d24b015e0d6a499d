package tellosimulator.testing;

import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** An independent decoder: the program ffmpeg, for tests that need {@link Tool#FFMPEG}. */
public final class Ffmpeg {

  /**
   * The result of decoding.
   *
   * @param pictures brightness of each pixel, row by row, one byte each
   * @param complaints its output of warnings and errors
   */
  public record Decoded(List<byte[]> pictures, String complaints) {}

  private Ffmpeg() {}

  /**
   * Decodes an H.264 stream.
   *
   * @param pixels number of pixels per frame
   * @param folder for temporary files
   * @param options of the decoder
   */
  public static Decoded decode(byte[] stream, int pixels, Path folder, String... options)
      throws IOException, InterruptedException {
    List<String> input = new ArrayList<>(List.of(options));
    input.addAll(List.of("-f", "h264"));
    return decode(Files.write(folder.resolve("stream.h264"), stream), pixels, folder, input);
  }

  /**
   * Decodes a video file.
   *
   * @param pixels number of pixels per frame
   * @param folder for temporary files
   */
  public static Decoded decodeFile(Path film, int pixels, Path folder)
      throws IOException, InterruptedException {
    return decode(film, pixels, folder, List.of());
  }

  private static Decoded decode(Path input, int pixels, Path folder, List<String> options)
      throws IOException, InterruptedException {
    Path output = folder.resolve("pictures.raw");
    Path errors = folder.resolve("errors.txt");
    List<String> command = new ArrayList<>(List.of("-nostdin", "-hide_banner", "-v", "warning"));
    command.addAll(options);
    command.addAll(List.of("-i", input.toString()));
    command.addAll(List.of("-fps_mode", "passthrough", "-f", "rawvideo", "-pix_fmt", "gray"));
    command.addAll(List.of("-y", output.toString()));
    int status =
        Tool.FFMPEG
            .command(command.toArray(String[]::new))
            .redirectError(errors.toFile())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start()
            .waitFor();
    String complaints = Files.readString(errors, StandardCharsets.UTF_8);
    if (status != 0) {
      fail("ffmpeg ended with " + status + ": " + complaints);
    }
    return new Decoded(cut(Files.readAllBytes(output), pixels), complaints);
  }

  private static List<byte[]> cut(byte[] all, int pixels) {
    List<byte[]> pictures = new ArrayList<>();
    for (int from = 0; from + pixels <= all.length; from += pixels) {
      pictures.add(Arrays.copyOfRange(all, from, from + pixels));
    }
    return pictures;
  }
}
