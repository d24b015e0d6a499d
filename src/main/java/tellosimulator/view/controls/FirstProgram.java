package tellosimulator.view.controls;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Locale;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.StackPane;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Shows a short Python program that flies a drone of this simulator. A button copies the program.
 * Confined to the JavaFX thread.
 */
public final class FirstProgram extends StackPane {

  private final Label program = new Label();
  private final CopyButton copy;

  /**
   * @param id the prefix of the ids of its parts
   */
  public FirstProgram(String id, Language language) {
    Messages messages = language.messages(FirstProgram.class);
    getStyleClass().add("program");
    getStylesheets().add(FirstProgram.class.getResource("program.css").toExternalForm());
    program.setId(id + "-program");
    program.setMinSize(USE_PREF_SIZE, USE_PREF_SIZE);
    copy = new CopyButton(messages.text("program.copy-tip"), program::getText);
    copy.setId(id + "-copy-program");
    copy.textProperty().bind(messages.text("program.copy"));
    StackPane.setAlignment(program, Pos.TOP_LEFT);
    StackPane.setAlignment(copy, Pos.TOP_RIGHT);
    getChildren().addAll(program, copy);
  }

  /**
   * Returns the button that copies the program. The button lies over the program unless the caller
   * lays it out elsewhere.
   */
  CopyButton copyButton() {
    return copy;
  }

  /**
   * Sets the addresses at which the drone accepts commands; the program uses the most useful one.
   *
   * @return the address that the program uses, as users type it
   */
  public String fly(List<InetSocketAddress> addresses) {
    InetSocketAddress address = AddressList.mostUsefulFirst(addresses).get(0);
    program.setText(python(address));
    return AddressList.text(address);
  }

  /** Returns the program for djitellopy. The README contains the same lines. */
  static String python(InetSocketAddress address) {
    return String.format(
        Locale.ROOT,
        """
        from djitellopy import Tello

        host = "%s"
        tello = Tello(host)
        tello.address = (host, %d)
        tello.connect()
        tello.takeoff()
        tello.move_forward(100)
        tello.land()
        """,
        address.getAddress().getHostAddress(),
        address.getPort());
  }
}
