package tellosimulator.view.layout;

import java.net.InetSocketAddress;
import java.util.Locale;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.StackPane;
import tellosimulator.view.controls.CopyButton;
import tellosimulator.view.text.Messages;

/** A short Python program that flies a drone of this simulator, to copy. For the JavaFX thread. */
final class FirstProgram extends StackPane {

  private final Label program = new Label();

  FirstProgram(Messages messages) {
    getStyleClass().add("program");
    program.setId("help-program");
    program.setMinSize(USE_PREF_SIZE, USE_PREF_SIZE);
    CopyButton copy = new CopyButton(messages.text("copy-program-tip"), program::getText);
    copy.setId("help-copy-program");
    copy.textProperty().bind(messages.text("copy-program"));
    StackPane.setAlignment(program, Pos.TOP_LEFT);
    StackPane.setAlignment(copy, Pos.TOP_RIGHT);
    getChildren().addAll(program, copy);
  }

  /** Flies the drone that takes commands at an address. */
  void fly(InetSocketAddress address) {
    program.setText(python(address));
  }

  /** The program for djitellopy, whose lines the README has, too. */
  static String python(InetSocketAddress address) {
    String host = address.getAddress().getHostAddress();
    return String.format(
        Locale.ROOT,
        """
        from djitellopy import Tello

        tello = Tello("%1$s")
        tello.address = ("%1$s", %2$d)
        tello.connect()
        tello.takeoff()
        tello.move_forward(100)
        tello.land()
        """,
        host,
        address.getPort());
  }
}
