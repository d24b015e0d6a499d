package tellosimulator.command;

import tellosimulator.words.Phrase;

/**
 * The refusal of a command.
 *
 * @param reply the drone's reply
 * @param reason the reason, worded to follow "refused: "
 */
record Refusal(Reply reply, Phrase reason) {}
