package tellosimulator.command;

import tellosimulator.words.Phrase;

/**
 * Why a command is not carried out.
 *
 * @param reply what the drone sends
 * @param reason in plain words that follow "refused: "
 */
record Refusal(Reply reply, Phrase reason) {}
