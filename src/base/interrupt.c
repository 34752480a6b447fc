/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/interrupt.h"
#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t noted;
static const int caught[] = { SIGINT, SIGTERM, SIGHUP };
enum { CAUGHT = sizeof caught / sizeof *caught };

static void note(int number)
{
    noted = number;
    for (int i = 0; i < CAUGHT; i++) (void)signal(caught[i], SIG_DFL);
}

void wf_interrupt_catch(void)
{
    /* SA_RESTART: a read from a drawing program goes on; the loops look at the flag */
    struct sigaction act = { .sa_handler = note, .sa_flags = SA_RESTART }, before;
    for (int i = 0; i < CAUGHT; i++) sigaddset(&act.sa_mask, caught[i]);
    for (int i = 0; i < CAUGHT; i++)
        if (!sigaction(caught[i], NULL, &before) && before.sa_handler != SIG_IGN)
            (void)sigaction(caught[i], &act, NULL);
}

int wf_interrupted(void) { return noted; }
