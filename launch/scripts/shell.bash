# What ./ws shell reads in place of ~/.bashrc, which it reads first: that may put another
# python3 first on PATH.
[ ! -f ~/.bashrc ] || . ~/.bashrc
. "$WORKSPACE_SETUP"
PATH=$WORKSPACE_BIN:$PATH
PS1="(ws) $PS1"
