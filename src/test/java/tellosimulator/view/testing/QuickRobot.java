package tellosimulator.view.testing;

import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.settle;

import java.util.List;
import java.util.concurrent.Callable;
import javafx.geometry.Point2D;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.stage.Window;
import org.testfx.api.FxRobot;
import org.testfx.robot.KeyboardRobot;
import org.testfx.robot.Motion;
import org.testfx.robot.MouseRobot;
import org.testfx.service.query.PointQuery;

/**
 * A mouse and a keyboard that go on as soon as the window has taken each input. TestFX's robot
 * sleeps 50 ms after each input, and moves the mouse in up to 200 steps, which together took more
 * than half the time of the window tests. For a test's thread.
 */
public final class QuickRobot extends FxRobot {

  private final MouseRobot mouse = robotContext().getMouseRobot();
  private final KeyboardRobot keyboard = robotContext().getKeyboardRobot();

  @Override
  public QuickRobot interact(Runnable work) {
    return interact(
        () -> {
          work.run();
          return true;
        });
  }

  @Override
  public <T> QuickRobot interact(Callable<T> work) {
    onFxThread(work);
    return settled();
  }

  @Override
  public QuickRobot press(KeyCode... keys) {
    for (KeyCode key : keys) {
      keyboard.pressNoWait(key);
      settle();
    }
    return this;
  }

  @Override
  public QuickRobot release(KeyCode... keys) {
    List<KeyCode> released = List.of(keys.length == 0 ? pressedKeys() : keys);
    for (KeyCode key : released) {
      keyboard.releaseNoWait(key);
      settle();
    }
    return this;
  }

  private KeyCode[] pressedKeys() {
    return keyboard.getPressedKeys().toArray(KeyCode[]::new);
  }

  @Override
  public QuickRobot push(KeyCode... combination) {
    press(combination);
    for (int i = combination.length - 1; i >= 0; i--) {
      release(combination[i]);
    }
    return this;
  }

  @Override
  public QuickRobot type(KeyCode... keys) {
    for (KeyCode key : keys) {
      keyboard.pressNoWait(key);
      keyboard.releaseNoWait(key);
      settle();
    }
    return this;
  }

  @Override
  public QuickRobot type(KeyCode key, int times) {
    for (int i = 0; i < times; i++) {
      type(key);
    }
    return this;
  }

  /** Into the window that has the keyboard. */
  @Override
  public QuickRobot write(String text) {
    Scene scene = window(Window::isFocused).getScene();
    for (int i = 0; i < text.length(); i++) {
      char character = text.charAt(i);
      KeyCode key = character == '\n' ? KeyCode.ENTER : KeyCode.UNDEFINED;
      robotContext().getBaseRobot().typeKeyboard(scene, key, Character.toString(character));
    }
    return settled();
  }

  @Override
  public QuickRobot press(MouseButton... buttons) {
    mouse.pressNoWait(buttons);
    return settled();
  }

  @Override
  public QuickRobot release(MouseButton... buttons) {
    mouse.releaseNoWait(buttons);
    return settled();
  }

  @Override
  public QuickRobot clickOn(MouseButton... buttons) {
    mouse.pressNoWait(buttons);
    return release(buttons);
  }

  @Override
  public QuickRobot clickOn(PointQuery point, Motion motion, MouseButton... buttons) {
    return moveTo(point, motion).clickOn(buttons);
  }

  /** Waits for nothing between the clicks, which must not be far apart. */
  @Override
  public QuickRobot doubleClickOn(PointQuery point, Motion motion, MouseButton... buttons) {
    moveTo(point, motion);
    mouse.pressNoWait(buttons);
    mouse.releaseNoWait(buttons);
    return clickOn(buttons);
  }

  @Override
  public QuickRobot drag(MouseButton... buttons) {
    return press(buttons);
  }

  @Override
  public QuickRobot drag(PointQuery point, MouseButton... buttons) {
    return moveTo(point, Motion.DEFAULT).drag(buttons);
  }

  @Override
  public QuickRobot drop() {
    return release(new MouseButton[0]);
  }

  @Override
  public QuickRobot dropTo(PointQuery point) {
    return moveTo(point, Motion.DEFAULT).drop();
  }

  @Override
  public QuickRobot dropBy(double x, double y) {
    return moveBy(x, y, Motion.DEFAULT).drop();
  }

  /** Also when the goal goes elsewhere while the mouse is on its way. */
  @Override
  public QuickRobot moveTo(PointQuery point, Motion motion) {
    glideTo(point.query());
    mouse.moveNoWait(point.query());
    return settled();
  }

  @Override
  public QuickRobot moveBy(double x, double y, Motion motion) {
    return glideTo(robotContext().getBaseRobot().retrieveMouse().add(x, y));
  }

  /** With a stop halfway, as a drag that is but one step is none. */
  private QuickRobot glideTo(Point2D target) {
    mouse.moveNoWait(robotContext().getBaseRobot().retrieveMouse().midpoint(target));
    mouse.moveNoWait(target);
    return settled();
  }

  private QuickRobot settled() {
    settle();
    return this;
  }
}
