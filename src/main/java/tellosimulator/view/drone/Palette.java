package tellosimulator.view.drone;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import javafx.scene.image.Image;
import javafx.scene.image.PixelWriter;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;

/**
 * The colours of a drone's parts. All of them are in one small picture, so that a whole body is one
 * mesh with one material. Assumed: by eye, from pictures of a Tello.
 */
enum Palette {
  COVER(Color.web("#eceded")),
  SEAM(Color.web("#a9adb2")),
  UNDERSIDE(Color.web("#33363b")),
  NOSE(Color.web("#17181b")),
  LENS_RING(Color.web("#4a4e55")),
  LENS(Color.web("#1d2c4d")),
  GLINT(Color.web("#9cc3f5")),
  ARM(Color.web("#2b2d31")),
  MOTOR(Color.web("#3d4147")),
  CAP(Color.web("#8d9198")),
  GUARD(Color.web("#222428")),
  PROPELLER(Color.web("#4b4f57")),
  FOOT(Color.web("#6a6e75"));

  /** Pixels from one colour to the next; what lies between hides the neighbours from filters. */
  private static final int CELL = 8;

  private final Color color;

  Palette(Color color) {
    this.color = color;
  }

  /** Its place in the order of all. */
  int index() {
    return Arrays.asList(values()).indexOf(this);
  }

  /** Where the colour lies in the picture, from 0 at the left to 1. */
  float u() {
    return (index() + 0.5f) / values().length;
  }

  /** The picture for a drone with a cover of some colour. */
  static Image picture(Color cover) {
    Map<Palette, Color> colors = new EnumMap<>(Palette.class);
    for (Palette part : values()) {
      colors.put(part, part == COVER ? cover : part.color);
    }
    WritableImage picture = new WritableImage(CELL * values().length, CELL);
    PixelWriter writer = picture.getPixelWriter();
    for (int x = 0; x < CELL * values().length; x++) {
      for (int y = 0; y < CELL; y++) {
        writer.setColor(x, y, colors.get(values()[x / CELL]));
      }
    }
    return picture;
  }
}
