package tellosimulator.scenery.texture;

import static tellosimulator.scenery.texture.AlphaMask.Point.polyline;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.texture.AlphaMask.Arc;
import tellosimulator.scenery.texture.AlphaMask.Point;

/**
 * A stroke font with digits, the minus sign, the letters x and y, and an arrow to the right. In
 * font coordinates, a digit is 1 high and about 0.6 wide and is centred at the origin; y points
 * down.
 */
public final class StrokeFont {

  private static final double UP = -Math.PI / 2;

  private StrokeFont() {}

  /**
   * Draws a character.
   *
   * @param character a character in this font
   * @param center centre of the character
   * @param height height of a digit [pixels]
   */
  public static void draw(AlphaMask mask, char character, Point center, double height) {
    for (List<Point> stroke : strokes(character)) {
      List<Point> way = new ArrayList<>();
      for (Point point : stroke) {
        way.add(new Point(center.x() + height * point.x(), center.y() + height * point.y()));
      }
      mask.stroke(way, 0.15 * height);
    }
  }

  private static List<List<Point>> strokes(char character) {
    return switch (character) {
      case '0' -> List.of(bow(0, 0.425, 0, 2 * Math.PI));
      case '1' -> List.of(polyline(-0.16, -0.24, 0.06, -0.425, 0.06, 0.425));
      case '2' ->
          List.of(
              bow(-0.2, 0.225, -Math.PI, 0.2 * Math.PI),
              polyline(0.178, -0.068, -0.22, 0.425, 0.24, 0.425));
      case '3' ->
          List.of(
              bow(-0.215, 0.21, -0.9 * Math.PI, -UP),
              bow(0.21, 0.215, UP, 0.9 * Math.PI),
              polyline(-0.06, 0, 0, 0));
      case '4' -> List.of(polyline(0.1, 0.425, 0.1, -0.425, -0.25, 0.2, 0.26, 0.2));
      case '5' ->
          List.of(
              polyline(0.2, -0.425, -0.16, -0.425, -0.2, 0.0),
              bow(0.15, 0.275, -0.82 * Math.PI, 0.85 * Math.PI));
      case '6' ->
          List.of(
              bow(0.18, 0.245, 0, 2 * Math.PI), polyline(-0.24, 0.16, -0.16, -0.12, 0.08, -0.425));
      case '7' -> List.of(polyline(-0.24, -0.425, 0.24, -0.425, -0.08, 0.425));
      case '8' -> List.of(bow(-0.215, 0.21, 0, 2 * Math.PI), bow(0.2, 0.225, 0, 2 * Math.PI));
      case '9' ->
          List.of(
              bow(-0.18, 0.245, 0, 2 * Math.PI), polyline(0.24, -0.16, 0.16, 0.12, -0.08, 0.425));
      case '-' -> List.of(polyline(-0.18, 0.02, 0.18, 0.02));
      case 'x' -> List.of(polyline(-0.2, -0.12, 0.2, 0.425), polyline(0.2, -0.12, -0.2, 0.425));
      case 'y' -> List.of(polyline(-0.2, -0.12, 0.02, 0.3), polyline(0.2, -0.12, -0.12, 0.6));
      case '→' -> List.of(polyline(-0.36, 0, 0.36, 0), polyline(0.12, -0.2, 0.36, 0, 0.12, 0.2));
      default ->
          throw new IllegalArgumentException(
              "character is " + character + ", but must be a digit, -, x, y or →");
    };
  }

  /** Returns an arc of an ellipse that is as wide as a digit and centred at height y. */
  private static List<Point> bow(double y, double radius, double from, double to) {
    return new Arc(new Point(0, y), new Point(0.24, radius), from, to).points();
  }
}
