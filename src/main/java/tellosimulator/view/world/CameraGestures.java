package tellosimulator.view.world;

import javafx.scene.input.GestureEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.RotateEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.input.ZoomEvent;
import javafx.scene.layout.Region;

/**
 * Moves the simulator camera by mouse, touchpad and touch: the left button rotates, the right
 * button or the pressed wheel pans, and scrolling zooms. Movements are finer with Ctrl and coarser
 * with Shift.
 */
final class CameraGestures {

  /** Factor for movements with Ctrl. Decided. */
  static final double FINE = 0.15;

  /** Factor for movements with Shift. Decided. */
  static final double STRONG = 5;

  private final Region picture;
  private final SimulatorCamera camera;
  private double lastX;
  private double lastY;

  private CameraGestures(Region picture, SimulatorCamera camera) {
    this.picture = picture;
    this.camera = camera;
  }

  /** Makes the gestures on a node move the camera. */
  static void install(Region picture, SimulatorCamera camera) {
    CameraGestures gestures = new CameraGestures(picture, camera);
    picture.addEventHandler(MouseEvent.MOUSE_PRESSED, gestures::press);
    picture.addEventHandler(MouseEvent.MOUSE_DRAGGED, gestures::drag);
    picture.addEventHandler(ScrollEvent.SCROLL, gestures::scroll);
    picture.addEventHandler(ZoomEvent.ZOOM, gestures::zoom);
    picture.addEventHandler(RotateEvent.ROTATE, gestures::rotate);
  }

  /** Returns the factor by which a movement is multiplied. */
  static double strength(boolean fine, boolean strong) {
    return fine ? FINE : strong ? STRONG : 1;
  }

  private void press(MouseEvent event) {
    lastX = event.getX();
    lastY = event.getY();
    picture.requestFocus();
  }

  private void drag(MouseEvent event) {
    double strength = strength(event.isControlDown(), event.isShiftDown());
    double right = (event.getX() - lastX) * strength;
    double down = (event.getY() - lastY) * strength;
    lastX = event.getX();
    lastY = event.getY();
    if (event.isSecondaryButtonDown() || event.isMiddleButtonDown()) {
      camera.shift(right, down, picture.getHeight());
    } else if (event.isPrimaryButtonDown() || event.getButton() == MouseButton.PRIMARY) {
      camera.turn(right, down);
    }
    event.consume();
  }

  private void scroll(ScrollEvent event) {
    double strength = strength(event);
    if (event.isDirect()) {
      if (event.getTouchCount() > 1) { // one finger is reported as a mouse drag
        camera.shift(
            event.getDeltaX() * strength, event.getDeltaY() * strength, picture.getHeight());
      }
    } else {
      camera.zoom(pixels(event) * strength);
    }
    event.consume();
  }

  /**
   * Returns the scrolled distance [px]. JavaFX reports the wheel as horizontal while Shift is held.
   */
  private static double pixels(ScrollEvent event) {
    return event.getDeltaY() == 0 && event.isShiftDown() ? event.getDeltaX() : event.getDeltaY();
  }

  private void zoom(ZoomEvent event) {
    camera.zoomBy(Math.pow(event.getZoomFactor(), strength(event)));
    event.consume();
  }

  private void rotate(RotateEvent event) {
    camera.rotate(event.getAngle() * strength(event));
    event.consume();
  }

  private static double strength(GestureEvent event) {
    return strength(event.isControlDown(), event.isShiftDown());
  }
}
