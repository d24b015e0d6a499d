package tellosimulator.video;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.function.IntPredicate;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.picture.Picture;

/** A picture from the first drone, and queries about it. */
final class Still {

  /** Half the width and height of the drone's video. */
  static final int WIDTH = DroneOptics.WIDTH / 2;

  static final int HEIGHT = DroneOptics.HEIGHT / 2;

  private static final Supplier<FrameSource> CAMERAS = new SoftwareCameras(DroneOptics.DEFAULT);

  private final BufferedImage image;

  private Still(BufferedImage image) {
    this.image = image;
  }

  /** Renders the forward camera. */
  static Still ahead(SimSnapshot snapshot) {
    return of(snapshot, new CameraId(1, false));
  }

  static Still of(SimSnapshot snapshot, CameraId camera) {
    Picture picture = new Picture(WIDTH, HEIGHT);
    CAMERAS.get().film(snapshot, camera, picture);
    return new Still(image(picture));
  }

  static Still read(Path file) {
    try {
      return new Still(ImageIO.read(file.toFile()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  void write(Path file) throws IOException {
    ImageIO.write(image, "png", file.toFile());
  }

  /** Returns packed red, green and blue. */
  int rgb(int x, int y) {
    return image.getRGB(x, y) & 0xffffff;
  }

  /** Returns the mean column of the matching pixels; NaN if there are none. */
  double column(IntPredicate ofRgb) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        if (ofRgb.test(rgb(x, y))) {
          sum += x + 0.5;
          count++;
        }
      }
    }
    return sum / count;
  }

  /** Returns the topmost row in a column with a matching pixel; the height if there is none. */
  int firstRow(int column, IntPredicate ofRgb) {
    for (int y = 0; y < HEIGHT; y++) {
      if (ofRgb.test(rgb(column, y))) {
        return y;
      }
    }
    return HEIGHT;
  }

  /** Returns the peak signal-to-noise ratio of all channels [dB]. */
  double likeness(Still other) {
    double squares = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        for (int shift = 0; shift < 24; shift += 8) {
          double difference = (rgb(x, y) >> shift & 255) - (other.rgb(x, y) >> shift & 255);
          squares += difference * difference;
        }
      }
    }
    return 10 * Math.log10(255.0 * 255 * 3 * WIDTH * HEIGHT / squares);
  }

  /** Converts to RGB by ITU-R BT.601, as decoders do. */
  private static BufferedImage image(Picture picture) {
    BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        int color = y / 2 * (WIDTH / 2) + x / 2;
        double luma = 255.0 / 219 * ((picture.y()[y * WIDTH + x] & 255) - 16);
        double blue = 255.0 / 224 * ((picture.u()[color] & 255) - 128);
        double red = 255.0 / 224 * ((picture.v()[color] & 255) - 128);
        int r = channel(luma + 1.402 * red);
        int g = channel(luma - 0.344 * blue - 0.714 * red);
        image.setRGB(x, y, r << 16 | g << 8 | channel(luma + 1.772 * blue));
      }
    }
    return image;
  }

  private static int channel(double value) {
    return (int) Math.max(0, Math.min(255, Math.round(value)));
  }
}
