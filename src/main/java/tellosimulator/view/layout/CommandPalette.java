package tellosimulator.view.layout;

import javafx.application.Platform;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * A search field for commands with a list of matches below it; Enter or a click runs the selected
 * command. Confined to the JavaFX thread.
 */
final class CommandPalette extends VBox {

  private static final double WIDTH = 560;

  /** Height of the list [px]. Decided: fits ten commands. */
  private static final double LIST_HEIGHT = 330;

  private final Messages messages;
  private final WindowCommands commands;
  private final Runnable close;
  private final TextField field = Nodes.named(new TextField(), "command-search");
  private final ListView<WindowCommand> list = Nodes.named(new ListView<>(), "command-list");

  /**
   * @param close hides the palette
   */
  CommandPalette(Language language, WindowCommands commands, Runnable close) {
    this.messages = language.messages(CommandPalette.class);
    this.commands = commands;
    this.close = close;
    Nodes.named(this, "command-palette", "page", "command-palette");
    getStylesheets().add(Page.class.getResource("pages.css").toExternalForm());
    setMaxSize(WIDTH, USE_PREF_SIZE);
    initializeParts();
    setupEventHandlers();
    search();
  }

  /** Returns the search field. */
  TextField field() {
    return field;
  }

  private void initializeParts() {
    field.promptTextProperty().bind(messages.text("commands-prompt"));
    field.accessibleTextProperty().bind(messages.text("key-commands"));
    field.accessibleHelpProperty().bind(messages.text("commands-prompt"));
    list.setPrefHeight(LIST_HEIGHT);
    list.setFocusTraversable(false); // the search field handles the list's keys
    list.accessibleTextProperty().bind(messages.text("key-commands"));
    list.setCellFactory(view -> new CommandCell());
    list.setPlaceholder(messages.label("commands-none"));
    Label examples = messages.label("commands-examples", "muted");
    examples.setWrapText(true);
    getChildren().addAll(field, list, examples);
  }

  private void setupEventHandlers() {
    field.textProperty().addListener((property, before, now) -> search());
    field
        .focusedProperty()
        .subscribe(
            focused -> {
              if (focused) {
                Platform.runLater(field::end); // otherwise the text typed so far would be selected
              }
            });
    addEventFilter(KeyEvent.KEY_PRESSED, this::press);
    list.addEventHandler(
        MouseEvent.MOUSE_CLICKED,
        click -> {
          if (list.getSelectionModel().getSelectedItem() != null) {
            run();
          }
        });
  }

  private void search() {
    list.getItems().setAll(commands.find(field.getText()));
    list.getSelectionModel().selectFirst();
    list.scrollTo(0);
  }

  private void press(KeyEvent event) {
    switch (event.getCode()) {
      case UP -> select(-1);
      case DOWN -> select(1);
      case ENTER -> run();
      case ESCAPE -> close.run();
      default -> {
        return;
      }
    }
    event.consume();
  }

  private void select(int step) {
    int count = list.getItems().size();
    if (count > 0) {
      int next = Math.floorMod(list.getSelectionModel().getSelectedIndex() + step, count);
      list.getSelectionModel().select(next);
      list.scrollTo(Math.max(0, next - 4));
    }
  }

  /**
   * Runs the selected command. Closes the palette first, because the command may open another page
   * or take the focus.
   */
  private void run() {
    WindowCommand chosen = list.getSelectionModel().getSelectedItem();
    if (chosen != null) {
      close.run();
      chosen.action().run();
    }
  }

  /** A cell that shows a command with its group and its key. */
  private final class CommandCell extends ListCell<WindowCommand> {

    private final Label title = new Label();
    private final Label group = Nodes.styled(new Label(), "muted");
    private final Label key = Nodes.styled(new Label(), "key-name");
    private final HBox parts = Nodes.styled(new HBox(title, group, key), "command-row");

    CommandCell() {
      Nodes.collapsible(Nodes.unshrinkable(key));
      Nodes.growing(title);
      setPrefWidth(0); // never wider than the list
    }

    @Override
    protected void updateItem(WindowCommand command, boolean empty) {
      super.updateItem(command, empty);
      if (empty || command == null) {
        setGraphic(null);
        setAccessibleText(null);
        return;
      }
      String symbols = command.key().map(known -> known.symbols(messages)).orElse("");
      title.setText(command.title().getValue());
      group.setText(messages.now(command.group().textKey()));
      key.setText(symbols);
      key.setVisible(!symbols.isEmpty());
      setAccessibleText((command.title().getValue() + " " + symbols).strip());
      setGraphic(parts);
    }
  }
}
